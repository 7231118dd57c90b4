package org.pendant.language.source;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class ByteTextTest {

  @Test
  void bytesOfAScriptAreShownAsTheTextTheyEncode() {
    assertEquals("Größe ≔ 𝄞", ByteText.decoded(ByteText.asBytes("Größe ≔ 𝄞")));
  }

  @Test
  void ourOwnWordsAreShownAsTheyAre() {
    assertEquals("a is -1.2 m/s², 20 °C, ≥ 𝄞", ByteText.decoded("a is -1.2 m/s², 20 °C, ≥ 𝄞"));
  }

  @Test
  void bothMayStandInOneText() {
    assertEquals(
        "speed of größe is 3 m/s²",
        ByteText.decoded("speed of " + ByteText.asBytes("größe") + " is 3 m/s²"));
  }

  @Test
  void bytesThatAreNoUtf8AreShownAsLatin1() {
    assertEquals("ÿ ü a", ByteText.decoded("\u00ff \u00fc a"));
    assertEquals("Ã", ByteText.decoded("\u00c3"));
    assertEquals("ä\u0080", ByteText.decoded("\u00e4\u0080"));
  }
}
