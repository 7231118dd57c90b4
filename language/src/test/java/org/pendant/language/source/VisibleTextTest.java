package org.pendant.language.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;

class VisibleTextTest {

  @Test
  void controlCharactersAreWrittenOut() {
    assertEquals("\\x1b]0;owned\\x07", VisibleText.of("\u001b]0;owned\u0007"));
    assertEquals("a\\x0db\\x08c\\x00d\\x7fe", VisibleText.of("a\rb\bc\0d\u007fe"));
    assertEquals("\\x9b2J\\x85", VisibleText.of("\u009b2J\u0085"));
  }

  @Test
  void marksThatTurnTheDirectionAreWrittenOut() {
    assertEquals("a\\u202etxt.exe\\u2069\\u2028", VisibleText.of("a\u202etxt.exe\u2069\u2028"));
  }

  @Test
  void everythingElseStays() {
    String text = "m/s² \t\u00e9 \u4e16\u754c \ud83d\ude00 \\x1b\nnext";
    assertSame(text, VisibleText.of(text));
  }

  @Test
  void aMessageHasOneLineAtTheMargin() {
    assertEquals("a\n    error: fake\n    b", VisibleText.message("a\nerror: fake\nb"));
  }
}
