package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.Component;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.desktop.help.Example;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.project.installation.text.InstallationText;

/**
 * Example files: opens copies of the programs that come with Pendant, and of what belongs to them.
 */
final class ExampleFiles {
  private static final String SCRIPT = ".script";

  private final ProgramFiles files;
  private final InstallationFiles installations;
  private final SceneFiles scenes;
  private final Notices notices;
  private final Component parent;
  private final Consumer<String> tell;

  ExampleFiles(
      ProgramFiles files,
      InstallationFiles installations,
      SceneFiles scenes,
      Notices notices,
      Component parent,
      Consumer<String> tell) {
    this.files = files;
    this.installations = installations;
    this.scenes = scenes;
    this.notices = notices;
    this.parent = parent;
    this.tell = tell;
  }

  /** Opens a copy that has no file yet, so that nothing is overwritten. */
  void open(Example example) {
    Background.run(
        example::text,
        text -> {
          files.openCopy(example.file(), text);
          tell.accept(text("openedACopyOfTheExample", example.file()));
          example.companions().forEach(each -> bring(example, each));
        },
        failed -> tell.accept(text("notOpened", failed.getMessage())));
  }

  /** Where nothing is around the arm a scene comes with its program. */
  private void bring(Example example, String companion) {
    if (companion.endsWith(SceneFile.ENDING) && scenes.current().isNone()) {
      surround(example, companion);
    } else if (example.meshes().files().contains(companion)) {
      // comes with the scene that names it
      return;
    } else if (companion.endsWith(SCRIPT)) {
      openBeside(companion);
    } else {
      offer(example, companion);
    }
  }

  /** The program of another controller of the cell. */
  private void openBeside(String companion) {
    Background.run(
        () -> Example.companion(companion),
        text -> files.openBehind(companion, text),
        failed -> tell.accept(text("notOpened", failed.getMessage())));
  }

  private void surround(Example example, String companion) {
    Background.run(
        () -> Example.companion(companion),
        text -> scenes.openCopy(companion, text, example.meshes()),
        failed -> tell.accept(text("notOpened", failed.getMessage())));
  }

  private void offer(Example example, String companion) {
    if (companion.endsWith(InstallationText.ENDING)) {
      ask(
          companion,
          text("isMadeForTheInstallation", example.file(), companion),
          text("useIt"),
          this::take);
    } else if (companion.endsWith(SceneFile.ENDING)) {
      ask(
          companion,
          text("isMadeForTheScene", example.file(), companion),
          text("useIt"),
          scene -> surround(example, scene));
    } else {
      String needs = text("needsInItsFolder", example.file(), companion);
      ask(companion, needs, text("saveACopy"), this::save);
    }
  }

  private void ask(String companion, String question, String yes, Consumer<String> bring) {
    notices.ask(
        "example-" + companion,
        question,
        List.of(
            new Choice("yes", yes, () -> bring.accept(companion)),
            Choice.nothing("close", text("close"))));
  }

  private void take(String companion) {
    Background.run(
        () -> Example.companion(companion),
        text -> installations.openCopy(companion, text),
        failed -> tell.accept(text("notOpened", failed.getMessage())));
  }

  private void save(String companion) {
    String ending = companion.substring(companion.lastIndexOf('.') + 1);
    SaveDialog.open(
        parent,
        new SaveRequest(
            text("saveExample", companion),
            Path.of(System.getProperty("user.home")).resolve(companion),
            List.of(ending),
            List.of()),
        file ->
            AtomicFile.write(file, Example.companion(companion).getBytes(StandardCharsets.UTF_8)),
        tell);
  }
}
