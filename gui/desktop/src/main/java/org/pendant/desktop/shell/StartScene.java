package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.pendant.desktop.session.SceneFile;

/**
 * Start scene: what is around the arm when a window opens.
 *
 * @param wanted the file that should be; empty for none
 * @param scene what is
 * @param trouble why that is not the same; empty if it is
 */
record StartScene(Optional<Path> wanted, SceneFile scene, String trouble) {
  /** Reads the scene that is wanted; not for the dispatch thread. */
  static StartScene of(Optional<Path> wanted) {
    if (wanted.isEmpty() || wanted.get().toString().isEmpty()) {
      return new StartScene(Optional.empty(), SceneFile.NONE, "");
    }
    try {
      return new StartScene(wanted, SceneFile.read(wanted.get()), "");
    } catch (IOException e) {
      return new StartScene(wanted, SceneFile.NONE, e.getMessage());
    }
  }
}
