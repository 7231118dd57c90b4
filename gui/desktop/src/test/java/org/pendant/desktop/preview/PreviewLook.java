package org.pendant.desktop.preview;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.fonts.inter.FlatInterFont;
import com.formdev.flatlaf.fonts.jetbrains_mono.FlatJetBrainsMonoFont;

/** The look of the desktop for windows that show a part of it. */
public final class PreviewLook {
  private PreviewLook() {}

  /** Installs fonts and theme; on the dispatch thread, before there is a window. */
  public static void install(boolean dark) {
    FlatInterFont.install();
    FlatJetBrainsMonoFont.install();
    FlatLaf.setPreferredFontFamily(FlatInterFont.FAMILY);
    FlatLaf.setPreferredMonospacedFontFamily(FlatJetBrainsMonoFont.FAMILY);
    change(dark);
  }

  /** Changes the theme of all windows. */
  public static void change(boolean dark) {
    var _ = dark ? FlatDarkLaf.setup() : FlatLightLaf.setup();
    FlatLaf.updateUI();
  }
}
