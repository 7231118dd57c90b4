package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class ThemeTest {
  @Test
  void unknownWordsMeanTheSystemsTheme() {
    assertEquals(Theme.DARK, Theme.of("dark"));
    assertEquals(Theme.SYSTEM, Theme.of("purple"));
  }

  @Test
  void eachSystemIsAskedInItsOwnWay() {
    assertEquals("gsettings", SystemTheme.command("Linux").getFirst());
    assertEquals("defaults", SystemTheme.command("Mac OS X").getFirst());
    assertEquals("reg", SystemTheme.command("Windows 11").getFirst());
  }

  @Test
  void answersOfTheSystemsAreUnderstood() {
    assertTrue(SystemTheme.dark("'prefer-dark'\n"));
    assertTrue(SystemTheme.dark("Dark\n"));
    assertTrue(SystemTheme.dark("    AppsUseLightTheme    REG_DWORD    0x0\r\n"));
    assertFalse(SystemTheme.dark("    AppsUseLightTheme    REG_DWORD    0x1\r\n"));
    assertFalse(SystemTheme.dark("'default'\n"));
    assertFalse(SystemTheme.dark(""));
  }
}
