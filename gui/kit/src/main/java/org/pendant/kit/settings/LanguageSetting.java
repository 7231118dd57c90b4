package org.pendant.kit.settings;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.text.Language;

/**
 * Which language the window speaks: one that was chosen, else the one that the environment asks
 * for, else the system's. It holds from one start to the next, since titles are read when parts of
 * the window are made.
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
    return settings.get(NAME).flatMap(Language::ofCode);
  }

  /** Chooses one for the next starts; empty for the system's. */
  public void choose(Optional<Language> language) {
    settings.put(NAME, language.map(Language::code).orElse(""));
  }

  /**
   * Makes it the language of the process and of Swing's own dialogs. Whoever does so does it before
   * the first part of the window is made.
   *
   * @param environment of the process, in which {@link Language#VARIABLE} may ask for one
   */
  public void apply(Map<String, String> environment) {
    chosen()
        .or(() -> Language.askedFor(environment))
        .ifPresent(each -> Locale.setDefault(Locale.Category.DISPLAY, Locale.of(each.code())));
    JComponent.setDefaultLocale(ofSwing());
  }

  /** Swing has its Chinese by the country: it finds nothing for the language alone. */
  private static Locale ofSwing() {
    return Language.ofProcess() == Language.CHINESE
        ? Locale.SIMPLIFIED_CHINESE
        : Locale.getDefault(Locale.Category.DISPLAY);
  }
}
