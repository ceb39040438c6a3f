/* What a bi-layer model holds, drawn. */
#ifndef WEFT_CLI_SHEET_BILAYER_H
#define WEFT_CLI_SHEET_BILAYER_H

#include "sheet.h"

/* Structure, noise, patches; masks, textons and their spectra. */
void sheet_bilayer(sheet* s);

/* A part of that name in a panel, or nothing where the model has none: at 100 %, its middle if it is larger. */
void sheet_named_part(sheet* s, const char* name, tones range);

#endif
