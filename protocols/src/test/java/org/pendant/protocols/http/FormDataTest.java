package org.pendant.protocols.http;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FormDataTest {
  private static final String TYPE = "multipart/form-data; boundary=xY";

  private static final String FORM =
      """
      --xY
      Content-Disposition: form-data; name="other"

      one
      --xY
      content-disposition: FORM-DATA; filename="a name=b"; name="file"
      Content-Type: text/plain

      two
      -- xY
      \0\377
      --xY--
      """;

  private static Optional<String> field(String type, String body, String name) {
    byte[] bytes = body.replace("\n", "\r\n").getBytes(StandardCharsets.ISO_8859_1);
    return FormData.field(type, bytes, name)
        .map(each -> new String(each, StandardCharsets.ISO_8859_1).replace("\r\n", "\n"));
  }

  @Test
  void findsTheContentOfAField() {
    assertEquals(Optional.of("one"), field(TYPE, FORM, "other"));
    assertEquals(Optional.of("two\n-- xY\n\0\377"), field(TYPE, FORM, "file"));
    assertEquals(Optional.empty(), field(TYPE, FORM, "a name=b"));
    assertEquals(Optional.empty(), field(TYPE, FORM, "File"));
  }

  @Test
  void aFieldMayBeEmpty() {
    String form = "--xY\nContent-Disposition: form-data; name=file\n\n\n--xY--\n";
    assertEquals(Optional.of(""), field(TYPE, form, "file"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "multipart/form-data;boundary=xY",
        "Multipart/Form-Data; charset=utf-8; Boundary=\"xY\" ; x=y"
      })
  void takesTheBoundaryInEachForm(String type) {
    assertEquals(Optional.of("one"), field(type, FORM, "other"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "application/json",
        "multipart/mixed; boundary=xY",
        "multipart/form-data",
        "multipart/form-data; boundary=",
        "multipart/form-data; boundary=xy"
      })
  void anotherTypeIsNoForm(String type) {
    assertEquals(Optional.empty(), field(type, FORM, "other"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "''",
        "'--xY'",
        "'--xY\n'",
        "'--xY--\n'",
        "'--xY\n\n--xY--'",
        "'--xY\nContent-Disposition: form-data; name=\"file\"\n\nno end'",
        "'--xY\nContent-Disposition: form-data; name=\"file\"\nno blank line\n--xY--'",
        "'--xYZ\nContent-Disposition: form-data; name=\"file\"\n\na\n--xYZ--'",
        "'x\n--xY\nContent-Disposition: form-data; name=\"file\"\n\na\n--xY--'"
      })
  void aBrokenFormHasNoFields(String body) {
    assertEquals(Optional.empty(), field(TYPE, body.translateEscapes(), "file"));
  }

  @Test
  void noCutOfAFormIsTakenForTheWhole() {
    String whole = FORM.substring(0, FORM.lastIndexOf("\n--xY--"));
    for (int i = 0; i < whole.length(); i++) {
      assertEquals(Optional.empty(), field(TYPE, FORM.substring(0, i), "file"), "cut at " + i);
    }
  }

  @Test
  void looksAtSixteenPartsOnly() {
    String part = "--xY\nContent-Disposition: form-data; name=a\n\n1\n";
    String file = "--xY\nContent-Disposition: form-data; name=file\n\n2\n--xY--\n";
    assertEquals(Optional.of("2"), field(TYPE, part.repeat(15) + file, "file"));
    assertEquals(Optional.empty(), field(TYPE, part.repeat(16) + file, "file"));
  }
}
