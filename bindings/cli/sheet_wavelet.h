/* What a model of wavelet noise holds, drawn. */
#ifndef WEFT_CLI_SHEET_WAVELET_H
#define WEFT_CLI_SHEET_WAVELET_H

#include "sheet.h"

/* Bands, their weights, tone curves, principal axes. */
void sheet_wavelet(sheet* s);

#endif
