package org.pendant.kit.theme;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.fonts.inter.FlatInterFont;
import com.formdev.flatlaf.fonts.jetbrains_mono.FlatJetBrainsMonoFont;
import com.formdev.flatlaf.util.FontUtils;
import com.formdev.flatlaf.util.UIScale;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javax.swing.InputMap;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.pendant.kit.settings.Settings;
import org.pendant.text.Language;

/**
 * Look of the desktop: the current theme and scale, changed live. Only the dispatch thread calls
 * it.
 */
public final class Look {
  private static final String THEME = "look.theme";
  private static final String SYSTEM_DARK = "look.system-dark";
  private static final String ZOOM = "look.zoom-percent";

  /** How large things may be, in percent of what the system says. */
  public static final List<Integer> ZOOMS = List.of(75, 100, 125, 150, 175, 200, 250, 300);

  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private final LateComponents late = new LateComponents();
  private Optional<CompletableFuture<Void>> textFont = Optional.empty();
  private Optional<CompletableFuture<Void>> otherFonts = Optional.empty();
  private boolean systemDark;

  /** The look that was chosen last. */
  public Look(Settings settings) {
    this.settings = settings;
    systemDark = settings.get(SYSTEM_DARK).map(Boolean::parseBoolean).orElse(false);
  }

  /**
   * Begins to load fonts on a thread of its own: that of texts, which {@link #install} waits for
   * first, and those of headings and scripts, since what it does besides takes as long.
   */
  public void loadFonts() {
    CompletableFuture<Void> texts =
        CompletableFuture.runAsync(
            FlatInterFont::installBasic,
            loading -> Thread.ofPlatform().daemon().name("fonts").start(loading));
    textFont = Optional.of(texts);
    otherFonts =
        Optional.of(
            texts.thenRun(
                () -> {
                  FlatInterFont.installSemiBold();
                  FlatJetBrainsMonoFont.install();
                }));
  }

  /** Sets fonts and colours up, before any component is made. */
  public void install() {
    if (textFont.isEmpty()) {
      loadFontsWhenUsed();
    } else {
      FontUtils.registerFontFamilyLoader(FlatInterFont.FAMILY_LIGHT, FlatInterFont::installLight);
    }
    // a font made before its family is loaded would keep the widths of another one
    textFont.ifPresent(CompletableFuture::join);
    FlatLaf.setPreferredFontFamily(FlatInterFont.FAMILY);
    FlatLaf.setPreferredLightFontFamily(FlatInterFont.FAMILY_LIGHT);
    if (Language.ofProcess() != Language.CHINESE) {
      // whose characters are from another font, which is bold where bold is asked for
      FlatLaf.setPreferredSemiboldFontFamily(FlatInterFont.FAMILY_SEMIBOLD);
    }
    FlatLaf.setPreferredMonospacedFontFamily(FlatJetBrainsMonoFont.FAMILY);
    apply();
    otherFonts.ifPresent(CompletableFuture::join);
    FontUtils.loadFontFamily(FlatJetBrainsMonoFont.FAMILY);
    UIScale.setSupportedZoomFactors(factors());
    UIScale.setZoomFactor(zoomPercent() / 100f);
    UncoveredEdges.follow();
    // nobody has a menu open before the first window is there
    EventQueue.invokeLater(SubmenuKeys::install);
  }

  private static void loadFontsWhenUsed() {
    FlatInterFont.installLazy();
    FlatJetBrainsMonoFont.installLazy();
  }

  private static float[] factors() {
    float[] factors = new float[ZOOMS.size()];
    for (int i = 0; i < factors.length; i++) {
      factors[i] = ZOOMS.get(i) / 100f;
    }
    return factors;
  }

  private void apply() {
    boolean dark = dark();
    FlatLaf.setGlobalExtraDefaults(colors(dark));
    FlatLaf.setup(dark ? new FlatDarkLaf() : new FlatLightLaf());
    // Dividers would take these keys from Pause and Run.
    InputMap keys = (InputMap) UIManager.get("SplitPane.ancestorInputMap");
    keys.remove(KeyStroke.getKeyStroke("F6"));
    keys.remove(KeyStroke.getKeyStroke("F8"));
  }

  private static Map<String, String> colors(boolean dark) {
    Map<String, String> colors = new HashMap<>();
    colors.put("@accentColor", dark ? "#6E9CCB" : "#2F5D8C");
    colors.put("@background", dark ? "#1F2226" : "#F3F5F7");
    colors.put("@foreground", dark ? "#DCE1E7" : "#1D2329");
    colors.put("@componentBackground", dark ? "#2B2F34" : "#FFFFFF");
    colors.put("@disabledForeground", dark ? "#858D97" : "#6F7780");
    if (Language.ofProcess() == Language.CHINESE) {
      colors.put("semibold.font", "bold");
    }
    colors.put("Component.arc", "6");
    colors.put("Button.arc", "6");
    colors.put("ScrollBar.width", "11");
    colors.put("ScrollBarUI", ScrollBarLook.class.getName());
    colors.put("TabbedPane.tabHeight", "28");
    colors.put("TabbedPane.inactiveUnderlineColor", "@accentColor");
    // Of buttons side by side the chosen one must not look like those that cannot be used.
    colors.put("ToggleButton.selectedBackground", "@accentColor");
    colors.put("ToggleButton.selectedForeground", dark ? "#14181C" : "#FFFFFF");
    colors.put("ToggleButton.disabledSelectedBackground", dark ? "#2C4058" : "#D3E1EF");
    colors.put("ToggleButton.toolbar.selectedBackground", dark ? "#2C4058" : "#D3E1EF");
    colors.put("ToggleButton.toolbar.selectedForeground", "@foreground");
    // What is chosen in a list, a table or a tree is seen as chosen while keys go elsewhere too.
    for (String kind : List.of("List", "Table", "Tree")) {
      colors.put(kind + ".selectionInactiveBackground", dark ? "#2C4058" : "#D3E1EF");
      colors.put(kind + ".selectionInactiveForeground", "@foreground");
    }
    colors.put("ToolTip.background", dark ? "#3A4048" : "#FFFFFF");
    // FlatLaf would read the style sheet of all HTML for it, 30 ms of a start; pages of help say
    // theirs.
    colors.put("Component.linkColor", "null");
    return colors;
  }

  /** What was chosen. */
  public Theme theme() {
    return Theme.of(settings.get(THEME).orElse(Theme.SYSTEM.word()));
  }

  /** Whether the colours are dark ones now. */
  public boolean dark() {
    return switch (theme()) {
      case LIGHT -> false;
      case DARK -> true;
      case SYSTEM -> systemDark;
    };
  }

  /** Changes the colours of everything that is open. */
  public void setTheme(Theme theme) {
    settings.put(THEME, theme.word());
    update();
  }

  /** What the system's theme turned out to be. */
  public void setSystemDark(boolean dark) {
    settings.put(SYSTEM_DARK, Boolean.toString(dark));
    if (dark != systemDark) {
      systemDark = dark;
      if (theme() == Theme.SYSTEM) {
        update();
      }
    }
  }

  private void update() {
    WindowBackgrounds.hold();
    apply();
    updateAll();
    tell();
  }

  private void updateAll() {
    FlatLaf.updateUI();
    late.lookChanged();
    for (Window each : Window.getWindows()) {
      LookFollower.tell(each);
    }
  }

  /** The scale on top of the system's, in percent. */
  public int zoomPercent() {
    return settings
        .get(ZOOM)
        .flatMap(text -> ZOOMS.stream().filter(each -> text.equals(each.toString())).findAny())
        .orElse(100);
  }

  /** Makes everything larger or smaller; one of {@link #ZOOMS}. */
  public void setZoomPercent(int percent) {
    settings.put(ZOOM, Integer.toString(percent));
    WindowBackgrounds.hold();
    UIScale.setZoomFactor(percent / 100f);
    updateAll();
    tell();
  }

  /** Makes everything one step larger (1) or smaller (-1). */
  public void zoom(int steps) {
    int index = ZOOMS.indexOf(zoomPercent()) + steps;
    if (index >= 0 && index < ZOOMS.size()) {
      setZoomPercent(ZOOMS.get(index));
    }
  }

  /** Tells {@code listener} after colours or scale have changed. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
