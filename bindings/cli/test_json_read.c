/* The program's JSON reader: what it takes, what it refuses and in which line, numbers to the bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>
#include <float.h>
#include <string.h>

#include "json_read.h"

static json_reader begin(const char* text) { return json_read_begin(text, strlen(text)); }

static void test_layout(void** state)
{
    json_reader in = begin(" {\"a\" : [1, 2\n,3 ],\r\n\t\"\\u0062\\n\": {}, \"c\": [[],\"\\\"\"]} \n");
    char key[JSON_KEY_ROOM];
    float value = 0, sum = 0;
    (void)state;
    assert_true(json_read_open(&in, '{'));
    assert_true(json_read_member(&in, key));
    assert_string_equal(key, "a");
    assert_true(json_read_open(&in, '['));
    while (json_read_value(&in) && json_read_float(&in, &value)) sum += value;
    assert_true(sum == 6);
    assert_true(json_read_member(&in, key));
    assert_string_equal(key, "b?");
    assert_true(json_read_open(&in, '{'));
    assert_false(json_read_member(&in, key));
    assert_true(json_read_member(&in, key));
    assert_true(json_read_open(&in, '['));
    assert_true(json_read_value(&in));
    assert_true(json_read_open(&in, '['));
    assert_false(json_read_value(&in));
    assert_true(json_read_value(&in));
    assert_true(json_read_text(&in, key, sizeof key));
    assert_string_equal(key, "\"");
    assert_false(json_read_value(&in));
    assert_false(json_read_member(&in, key));
    assert_true(json_read_end(&in));
}

/* Reads an array of numbers; answers the line of the error, 0 if there is none. */
static unsigned read_array(const char* text)
{
    json_reader in = begin(text);
    float value = 0;
    json_read_open(&in, '[');
    while (json_read_value(&in) && json_read_float(&in, &value)) continue;
    return json_read_end(&in) ? 0 : in.line;
}

static void test_refused_arrays(void** state)
{
    static const char* const refused[] = {"",
                                          "[",
                                          "[1",
                                          "[1,",
                                          "[1,]",
                                          "[,1]",
                                          "[1 2]",
                                          "[1]]",
                                          "[1}",
                                          "{1]",
                                          "[[1]]",
                                          "[01]",
                                          "[+1]",
                                          "[.5]",
                                          "[1.]",
                                          "[1e]",
                                          "[1e+]",
                                          "[- 1]",
                                          "[-]",
                                          "[nan]",
                                          "[1e39]",
                                          "[-4e38]",
                                          "[0x1]",
                                          "[1,5",
                                          "[null]",
                                          "[\"1\"]",
                                          "\f[1]",
                                          "[1]x",
                                          "\xef\xbb\xbf[1]",
                                          "[1e99999999999999999999]"};
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++)
        if (read_array(refused[i]) != 1) fail_msg("%s", refused[i]);
    assert_int_equal(read_array("[1]"), 0);
    assert_int_equal(read_array("[]"), 0);
    assert_int_equal(read_array("[1,\n2,\n\n+]"), 4);
    const char with_nul[] = "[1]\0";
    json_reader in = json_read_begin(with_nul, 4);
    assert_true(json_read_open(&in, '[') && json_read_value(&in));
    float value = 0;
    assert_true(json_read_float(&in, &value) && !json_read_value(&in));
    assert_false(json_read_end(&in));
}

static void test_refused_texts(void** state)
{
    static const char* const refused[] = {"",       "\"",      "\"a",       "a",           "\"\\",        "\"\\x\"",
                                          "\"\n\"", "\"\\u\"", "\"\\u12\"", "\"\\u12g4\"", "\"12345678\""};
    char text[8];
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        json_reader in = begin(refused[i]);
        if (json_read_text(&in, text, sizeof text) || json_read_fine(&in)) fail_msg("%s", refused[i]);
    }
}

static float read_one(const char* text)
{
    json_reader in = begin(text);
    float value = -7;
    assert_true(json_read_float(&in, &value) && json_read_end(&in));
    return value;
}

static void test_floats(void** state)
{
    uint32_t seed = 1;
    (void)state;
    assert_true(read_one("0.1") == 0.1f && read_one("-2.5e-3") == -2.5e-3f && read_one("1E2") == 100);
    assert_true(read_one("100000000000000000000000000000000000000") == 1e38f);
    assert_true(read_one("0.00000000000000000000000000000000000000000000000000000000000") == 0);
    assert_true(read_one("1e-999999") == 0 && read_one("0e999999") == 0);
    for (int i = 0; i < 200000; i++) {
        char text[32];
        float value = 0;
        uint32_t bits = seed = seed * 1664525 + 1013904223; /* Knuth's generator */
        memcpy(&value, &bits, sizeof value);
        if (!(value >= -FLT_MAX && value <= FLT_MAX)) continue;
        snprintf(text, sizeof text, "%.9g", (double)value);
        float back = read_one(text);
        assert_memory_equal(&back, &value, sizeof value);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layout),
        cmocka_unit_test(test_refused_arrays),
        cmocka_unit_test(test_refused_texts),
        cmocka_unit_test(test_floats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
