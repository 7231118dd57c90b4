package org.pendant.testing.run;

import java.io.IOException;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.testing.source.TestSources;

/**
 * Tested tree: a program tree that a test starts, in the installation that it belongs to.
 *
 * @param tree the tree
 * @param own the installation that it names, where that is there and none was given for all tests
 */
record TestedTree(TreeFile tree, Optional<Installation> own) {

  /**
   * Understands a file.
   *
   * @param given the installation of all tests
   * @throws BrokenTree if it holds no tree
   * @throws InstallationTrouble if its installation cannot be understood
   */
  static TestedTree of(String name, byte[] bytes, Optional<Installation> given, TestSources files)
      throws BrokenTree, InstallationTrouble {
    TreeFile bare = TreeFile.read(name, bytes);
    if (given.isPresent()) {
      return new TestedTree(bare.in(given.get()), Optional.empty());
    }
    Optional<Installation> own = beside(name, bare.tree().installation(), files);
    return new TestedTree(own.map(bare::in).orElse(bare), own);
  }

  private static Optional<Installation> beside(String name, String wanted, TestSources files)
      throws InstallationTrouble {
    if (wanted.isEmpty()) {
      return Optional.empty();
    }
    for (String each : InstallationFile.namesOf(wanted)) {
      String file = TestSources.beside(name, each);
      Optional<byte[]> bytes = there(file, files);
      if (bytes.isPresent()) {
        Optional<byte[]> variables =
            InstallationFile.variablesOf(file).flatMap(other -> there(other, files));
        return Optional.of(InstallationFile.read(file, bytes.get(), variables).installation());
      }
    }
    return Optional.empty();
  }

  private static Optional<byte[]> there(String file, TestSources files) {
    try {
      return Optional.of(files.read(file));
    } catch (IOException _) {
      // one of several names that it may have
      return Optional.empty();
    }
  }
}
