package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;

/**
 * Tree of a file: a program tree of a command line, in the installation that it belongs to.
 *
 * @param file the tree
 * @param own the installation that the program itself names, if it is there and none was given
 * @param notes what people should know
 */
record TreeOfFile(TreeFile file, Optional<Installation> own, List<String> notes) {
  TreeOfFile {
    notes = List.copyOf(notes);
  }

  /**
   * Understands a file.
   *
   * @param given the installation of the command line
   * @param files by which its installation is read
   * @throws BrokenTree if it holds no tree
   * @throws UsageException if its installation cannot be read
   */
  static TreeOfFile of(String name, byte[] bytes, Optional<Installation> given, SourceFiles files)
      throws BrokenTree, UsageException {
    TreeFile bare = TreeFile.read(name, bytes);
    String wanted = bare.tree().installation();
    List<String> ofInstallation = new ArrayList<>();
    Optional<Installation> found =
        given.isPresent() ? given : InstallationOption.beside(name, wanted, files, ofInstallation);
    TreeFile tree = found.map(bare::in).orElse(bare);
    List<String> notes = new ArrayList<>(tree.remarks());
    notes.addAll(ofInstallation);
    if (!wanted.isEmpty() && found.isEmpty()) {
      notes.add(text("installationMissing", name, wanted));
    }
    return new TreeOfFile(
        tree, given.isPresent() ? Optional.empty() : found.map(_ -> tree.installation()), notes);
  }
}
