/* libFuzzer's own mutation, then the checksums of the model file behind the first WEFT_FUZZ_HEAD bytes made right; one
 * input in sixteen keeps its wrong ones. */
#include "fuzz.h"

size_t LLVMFuzzerMutate(uint8_t* bytes, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t most, unsigned int seed);

size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t most, unsigned int seed)
{
    const size_t mutated = LLVMFuzzerMutate(bytes, size, most);
    if (mutated > WEFT_FUZZ_HEAD && seed % 16 != 0) fuzz_repair(bytes + WEFT_FUZZ_HEAD, mutated - WEFT_FUZZ_HEAD);
    return mutated;
}
