package org.pendant.desktop.shell;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SceneDraft;

/** Edited files: the files that people work on: nothing else is written onto them. */
final class EditedFiles {
  private EditedFiles() {}

  /** Those of all programs, of the installation and of the scene. */
  static List<Path> of(Programs programs, ActiveInstallation installation, SceneDraft scene) {
    return files(
        Stream.concat(
            programs.all().stream(), Stream.of(installation.document(), scene.document())));
  }

  /** Those of all programs but one, whose own file is replaced on purpose. */
  static List<Path> besides(ProgramDocument saved, Programs programs) {
    return files(programs.all().stream().filter(each -> each != saved));
  }

  private static List<Path> files(Stream<ProgramDocument> documents) {
    return documents.map(ProgramDocument::file).flatMap(Optional::stream).toList();
  }
}
