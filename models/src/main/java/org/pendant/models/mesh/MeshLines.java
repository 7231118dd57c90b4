package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.pendant.models.json.Json;

/** Mesh lines: the lines of a text, word by word; those without any are passed over. */
final class MeshLines {
  private final String text;
  private int at;
  private int line;
  private String[] words = {};

  MeshLines(byte[] bytes) {
    text = new String(bytes, StandardCharsets.ISO_8859_1);
  }

  /** Goes to the next line that has words; answers whether there is one. */
  boolean next() {
    while (at < text.length()) {
      int end = text.indexOf('\n', at);
      end = end < 0 ? text.length() : end;
      String stripped = text.substring(at, end).strip();
      at = end + 1;
      line++;
      if (!stripped.isEmpty()) {
        words = stripped.split("\\s+");
        return true;
      }
    }
    return false;
  }

  /** How many words this line has. */
  int words() {
    return words.length;
  }

  /** A word of this line. */
  String word(int index) {
    return words[index];
  }

  /** Whether this line begins with a word. */
  boolean is(String word) {
    return words[0].toLowerCase(Locale.ROOT).equals(word);
  }

  /** Refuses a line that begins with another word. */
  void require(String word) throws MeshException {
    if (!is(word)) {
      throw new MeshException(text("wrongWord", where(), Json.quoted(words[0]), word));
    }
  }

  /** A word that is a number. */
  double number(int index) throws MeshException {
    if (index >= words.length) {
      throw new MeshException(text("tooFewNumbers", where()));
    }
    try {
      return Double.parseDouble(words[index]);
    } catch (NumberFormatException _) {
      throw new MeshException(text("wordNoNumber", where(), Json.quoted(words[index])));
    }
  }

  /** This line, for messages. */
  String where() {
    return text("line", line);
  }
}
