package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class BlockEndTest {

  private static boolean missing(String text, int line) {
    List<String> lines = text.lines().toList();
    return BlockEnd.missing(lines::get, lines.size(), line - 1);
  }

  @Test
  void aNewHeadNeedsAnEnd() {
    assertTrue(missing("def f():", 1));
    assertTrue(missing("def f():\n  while True: # on and on\nend", 2));
    assertTrue(missing("def f():\n  if a:\n  if b:\n    x = 1\n  end\nend", 2));
    assertTrue(missing("thread t():\ndef f():\n  x = 1\nend", 1));
  }

  @Test
  void aHeadThatHasItsEndNeedsNone() {
    assertFalse(missing("def f():\n\n  x = 1\nend", 1));
    assertFalse(missing("def f():\n  if a:\n  else:\n    x = 1\n  end\nend", 2));
    assertFalse(missing("def f():\nx = 1\nend", 1));
    assertFalse(missing("if a: x = 1 end", 1));
  }

  @Test
  void otherLinesNeedNone() {
    assertFalse(missing("x = 1", 1));
    assertFalse(missing("def f():\n  if a:\n  else:\nend", 3));
    assertFalse(missing("textmsg(\"if a:", 1));
    assertFalse(missing("# def f():", 1));
  }

  @Test
  void wordsInStringsAndCommentsAreNoEnds() {
    assertTrue(missing("def f():\n  textmsg(\"end\") # end", 1));
    assertTrue(missing("def f():\n  append = send", 1));
  }
}
