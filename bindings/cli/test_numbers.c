/* The program's parsing of numbers: limits, signs, and everything that strtol would let pass. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "numbers.h"

static void test_unsigned(void** state)
{
    static const char* const refused[] = {"",   " 1",  "1 ",  "-1",  "+1", "18446744073709551616",
                                          "0x", "0xg", "1e3", "abc", "1.0"};
    uint64_t value = 0;
    (void)state;
    assert_true(parse_unsigned("0", &value) && value == 0);
    assert_true(parse_unsigned("18446744073709551615", &value) && value == UINT64_MAX);
    assert_true(parse_unsigned("0xFFFFFFFFFFFFFFFF", &value) && value == UINT64_MAX);
    assert_true(parse_unsigned("010", &value) && value == 10);
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) assert_false(parse_unsigned(refused[i], &value));
}

static void test_extent(void** state)
{
    static const char* const refused[] = {"",     "1",    "1x",           "x1",    "1x2x3", "1X2",
                                          "-1x2", "1x-2", "4294967296x1", "1 x 2", "1x2 ",  "0x"};
    extent value = {0, 0};
    (void)state;
    assert_true(parse_extent("640x480", &value) && value.width == 640 && value.height == 480);
    assert_true(parse_extent("0x0", &value) && value.width == 0 && value.height == 0);
    assert_true(parse_extent("4294967295x1", &value) && value.width == UINT32_MAX);
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) assert_false(parse_extent(refused[i], &value));
}

static void test_position(void** state)
{
    static const char* const refused[] = {
        "", "1", "1,", ",1", "1,2,3", "1, 2", "--1,2", "9223372036854775808,0", "-9223372036854775809,0"};
    position value = {0, 0};
    (void)state;
    assert_true(parse_position("-5,7", &value) && value.x == -5 && value.y == 7);
    assert_true(parse_position("-9223372036854775808,9223372036854775807", &value));
    assert_true(value.x == INT64_MIN && value.y == INT64_MAX);
    assert_true(parse_position("-0,+0", &value) && value.x == 0 && value.y == 0);
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) assert_false(parse_position(refused[i], &value));
}

static void test_real(void** state)
{
    static const char* const refused[] = {"", " 1", "1 ", "nan", "inf", "1e999", "1,5", "+1", "x"};
    double value = 0;
    (void)state;
    assert_true(parse_real("30", &value) && value == 30);
    assert_true(parse_real("-.5", &value) && value == -0.5);
    assert_true(parse_real("1e3", &value) && value == 1000);
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) assert_false(parse_real(refused[i], &value));
}

static void test_counts(void** state)
{
    uint32_t values[3];
    (void)state;
    assert_int_equal(parse_counts("3,1,4", values, 3), 3);
    assert_true(values[0] == 3 && values[1] == 1 && values[2] == 4);
    assert_int_equal(parse_counts("16", values, 3), 1);
    assert_int_equal(parse_counts("1,1,1,1", values, 3), 0);
    assert_int_equal(parse_counts("0", values, 3), 0);
    assert_int_equal(parse_counts("17", values, 3), 0);
    assert_int_equal(parse_counts("1,", values, 3), 0);
    assert_int_equal(parse_counts("", values, 3), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unsigned), cmocka_unit_test(test_extent), cmocka_unit_test(test_position),
        cmocka_unit_test(test_real),     cmocka_unit_test(test_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
