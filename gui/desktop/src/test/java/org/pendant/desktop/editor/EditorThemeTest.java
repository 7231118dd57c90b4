package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Font;
import org.junit.jupiter.api.Test;

final class EditorThemeTest {
  @Test
  void lettersThatTheFontDoesNotHaveComeFromOthers() {
    Font code = EditorTheme.codeFont();
    Font any = new Font(Font.DIALOG, Font.PLAIN, code.getSize());
    assertEquals(any.canDisplay('\u4e2d'), code.canDisplay('\u4e2d'));
  }
}
