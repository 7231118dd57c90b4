package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.desktop.session.SceneFile;

/**
 * Start scene: what is around the arm when a window opens.
 *
 * @param wanted the file that should be; empty for none
 * @param scene what is
 * @param trouble why that is not the same; empty if it is
 */
record StartScene(Optional<Path> wanted, SceneFile scene, String trouble) {
  /**
   * As {@link #of(Optional)}, with more devices.
   *
   * @param kinds of devices that a cell may have; one that has the name of another is there already
   */
  static StartScene of(Optional<Path> wanted, List<String> kinds) {
    StartScene read = of(wanted);
    Set<String> names =
        read.scene.equipment().devices().stream()
            .map(DeviceSetup::name)
            .collect(Collectors.toSet());
    List<String> missing = kinds.stream().filter(each -> !names.contains(each)).toList();
    if (missing.isEmpty()) {
      return read;
    }
    try {
      return new StartScene(read.wanted, read.scene.with(missing), read.trouble);
    } catch (IOException e) {
      return new StartScene(read.wanted, read.scene, e.getMessage());
    }
  }

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
