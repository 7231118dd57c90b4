package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class CommentToggleTest {
  private static String toggled(String text) {
    return Edit.apply(
        text, CommentToggle.edits(text, LineIndex.touched(text, new TextSpan(0, text.length()))));
  }

  @Test
  void marksStandInOneColumn() {
    assertEquals("  # if a:\n  #   b()\n\n  # end", toggled("  if a:\n    b()\n\n  end"));
  }

  @Test
  void secondToggleRestoresTheText() {
    String text = "def main():\n  # why\n  sync()\nend\n";
    assertEquals(text, toggled(toggled(text)));
  }

  @Test
  void commentsWithoutABlankBecomeCodeToo() {
    assertEquals("  sync()", toggled("  #sync()"));
  }

  @Test
  void oneLineOfCodeAmongCommentsMakesAllComments() {
    assertEquals("# # a\n# b()", toggled("# a\nb()"));
  }

  @Test
  void blankLinesAreLeftAlone() {
    assertEquals("  \n", toggled("  \n"));
  }
}
