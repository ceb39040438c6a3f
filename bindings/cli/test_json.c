/* The program's JSON writer: layout, escapes, bytes that are no UTF-8, numbers that JSON does not have. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "json.h"

static json begin(void)
{
    FILE* file = tmpfile();
    assert_non_null(file);
    return json_begin(file);
}

static void check(json* out, const char* expected)
{
    char text[1024];
    rewind(out->file);
    size_t length = fread(text, 1, sizeof text - 1, out->file);
    text[length] = '\0';
    fclose(out->file);
    assert_string_equal(text, expected);
}

static void test_layout(void** state)
{
    json out = begin();
    (void)state;
    json_object(&out, NULL);
    json_array(&out, "empty");
    json_end(&out);
    json_array(&out, "two");
    json_integer(&out, NULL, INT64_MIN);
    json_object(&out, NULL);
    json_unsigned(&out, "most", UINT64_MAX);
    json_end(&out);
    json_end(&out);
    json_truth(&out, "yes", 2);
    json_null(&out, "nothing");
    json_end(&out);
    check(&out,
          "{\n  \"empty\": [],\n  \"two\": [\n    -9223372036854775808,\n    {\n      \"most\": 18446744073709551615\n"
          "    }\n  ],\n  \"yes\": true,\n  \"nothing\": null\n}\n");
}

static void test_text(void** state)
{
    json out = begin();
    (void)state;
    json_array(&out, NULL);
    json_text(&out, NULL, "a\"b\\c\n\x01\x7f");
    json_text(&out, NULL, "\xc3\xa4 \xe2\x82\xac \xf0\x9f\x98\x80");
    json_text(&out, NULL, "\xff|\xc3|\xc0\x80|\xed\xa0\x80|\xf4\x90\x80\x80|\xe2\x82");
    json_end(&out);
    check(
        &out,
        "[\n  \"a\\\"b\\\\c\\u000a\\u0001\x7f\",\n  \"\xc3\xa4 \xe2\x82\xac \xf0\x9f\x98\x80\",\n"
        "  \"\\ufffd|\\ufffd|\\ufffd\\ufffd|\\ufffd\\ufffd\\ufffd|\\ufffd\\ufffd\\ufffd\\ufffd|\\ufffd\\ufffd\"\n]\n");
}

static void test_reals(void** state)
{
    json out = begin();
    (void)state;
    json_array(&out, NULL);
    json_real(&out, NULL, (double)0.1f);
    json_real(&out, NULL, -1e300);
    json_real(&out, NULL, 3);
    json_real(&out, NULL, (double)NAN);
    json_real(&out, NULL, (double)INFINITY);
    json_end(&out);
    check(&out, "[\n  0.100000001,\n  -1e+300,\n  3,\n  null,\n  null\n]\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layout),
        cmocka_unit_test(test_text),
        cmocka_unit_test(test_reals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
