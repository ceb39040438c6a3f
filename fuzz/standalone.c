/* fuzz_TARGET FOLDER...: gives every file of the folders to the target, so that a corpus is an ordinary test. */
#include "fuzz.h"
#include <dirent.h>

static int replay(const char* path)
{
    FILE* file = fopen(path, "rb");
    if (!file) return 0;
    static uint8_t bytes[1 << 20];
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    /* A block of its own size: a sanitizer sees every read beyond its end. */
    uint8_t* exact = malloc(size ? size : 1);
    if (!exact) return 0;
    memcpy(exact, bytes, size);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    return 1;
}

int main(int count, char** arguments)
{
    int replayed = 0;
    for (int i = 1; i < count; ++i) {
        DIR* folder = opendir(arguments[i]);
        if (!folder) {
            fprintf(stderr, "%s cannot be opened\n", arguments[i]);
            return 1;
        }
        for (struct dirent* entry = readdir(folder); entry; entry = readdir(folder)) {
            char path[4096];
            if (entry->d_name[0] == '.') continue;
            snprintf(path, sizeof path, "%s/%s", arguments[i], entry->d_name);
            if (!replay(path)) {
                fprintf(stderr, "%s cannot be read\n", path);
                return 1;
            }
            ++replayed;
        }
        closedir(folder);
    }
    printf("%d inputs\n", replayed);
    return replayed > 0 ? 0 : 1;
}
