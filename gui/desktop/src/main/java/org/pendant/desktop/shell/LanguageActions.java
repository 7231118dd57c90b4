package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.LanguageSetting;
import org.pendant.text.Language;

/** Choosing the language that the window speaks from its next start on. */
final class LanguageActions {
  private LanguageActions() {}

  /** Adds one action for each language, and one for the system's. */
  static void addTo(ActionTable actions, LanguageSetting setting, Consumer<String> tell) {
    Consumer<Optional<Language>> choose =
        language -> {
          setting.choose(language);
          tell.accept(
              text(
                  "languageFromNextStart", language.map(Language::title).orElse(text("asSystem"))));
        };
    for (Language each : Language.values()) {
      actions.add(
          Action.of(
                  "language." + each.code(),
                  text("languageIs", each.title()),
                  "",
                  () -> choose.accept(Optional.of(each)))
              .chosen(() -> setting.chosen().equals(Optional.of(each))));
    }
    actions.add(
        Action.of(
                "language.system",
                text("languageIs", text("asSystem")),
                "",
                () -> choose.accept(Optional.empty()))
            .chosen(() -> setting.chosen().isEmpty()));
  }
}
