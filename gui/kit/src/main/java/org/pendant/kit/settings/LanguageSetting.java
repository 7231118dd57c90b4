package org.pendant.kit.settings;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.text.Language;

/**
 * Which language the window speaks: one that was chosen, or the system's. It holds from one start
 * to the next, since titles are read when parts of the window are made.
 */
public final class LanguageSetting {
  private static final String NAME = "window.language";

  private final Settings settings;

  /** As the settings have it. */
  public LanguageSetting(Settings settings) {
    this.settings = settings;
  }

  /** The one that was chosen; empty for the system's. */
  public Optional<Language> chosen() {
    return settings.get(NAME).flatMap(LanguageSetting::ofCode);
  }

  /** Chooses one for the next starts; empty for the system's. */
  public void choose(Optional<Language> language) {
    settings.put(NAME, language.map(Language::code).orElse(""));
  }

  /**
   * Makes the chosen one the language of the process and of Swing's own dialogs. Whoever does so
   * does it before the first part of the window is made.
   */
  public void apply() {
    chosen().ifPresent(each -> Locale.setDefault(Locale.Category.DISPLAY, Locale.of(each.code())));
    JComponent.setDefaultLocale(Locale.getDefault(Locale.Category.DISPLAY));
  }

  private static Optional<Language> ofCode(String code) {
    for (Language each : Language.values()) {
      if (each.code().equals(code)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}
