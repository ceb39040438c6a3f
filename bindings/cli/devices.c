/* weft devices: what there is to work on, and why some of it cannot be used. */
#include "command.h"
#include "json.h"
#include "options.h"
#include "report.h"

#include <weft/weft.h>

static void write_json(json* out, const weft_device_info* device)
{
    json_object(out, NULL);
    json_text(out, "name", device->name);
    json_truth(out, "usable", device->status == WEFT_OK);
    json_text(out, "status", weft_status_name(device->status));
    json_truth(out, "exact", device->exact != 0);
    json_text(out, "description", device->description);
    json_end(out);
}

static void write_text(const weft_device_info* device)
{
    const char* state = device->status != WEFT_OK ? "refused" : device->exact ? "exact" : "not exact";
    printf("%-16s %-10s %s\n", device->name, state, device->description);
}

static int list(uint32_t count, const arguments* common)
{
    json out = json_begin(stdout);
    if (common->json) json_array(&out, NULL);
    for (uint32_t i = 0; i < count; i++) {
        weft_device_info device = WEFT_DEVICE_INFO_INIT;
        weft_status status = weft_device_get(i, &device);
        if (status != WEFT_OK) return failed_weft(status);
        if (common->json)
            write_json(&out, &device);
        else
            write_text(&device);
    }
    if (common->json) json_end(&out);
    return EXIT_FINE;
}

int command_devices(int count, char** words)
{
    static const char notes[] =
        "An exact device gives bit for bit the pixels of `scalar`. A refused one is listed with the reason. Plug-\n"
        "ins are found beside the library, or in the folder that WEFT_BACKEND_PATH names.";
    const command_line line = {"devices", "", "Lists the devices.", notes, NULL, 0, 0, 0};
    arguments common;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    uint32_t devices = 0;
    weft_status status = weft_device_count(&devices);
    return status == WEFT_OK ? list(devices, &common) : failed_weft(status);
}
