package org.pendant.desktop.cell;

import java.io.IOException;
import java.util.Map;
import java.util.function.Supplier;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneWriter;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.kit.text.Messages;

/** Scene refusal: why there cannot be a scene. */
final class SceneRefusal {
  private static final String FILE = "scene";

  private SceneRefusal() {}

  /**
   * What is wrong with what {@code wanted} makes, as a file or before; empty if nothing is.
   *
   * @param draft what is changed so
   * @param equipment the members for devices and rules that go with it
   */
  static String of(Supplier<Scene> wanted, SceneDraft draft, Map<String, String> equipment) {
    try {
      // what is shown here can be saved, and read again
      Scene scene = wanted.get();
      var _ =
          SceneFile.of(
              FILE, SceneWriter.write(scene, equipment), MeshFiles.of(scene, draft.meshesOfArms()));
      return "";
    } catch (IllegalArgumentException e) {
      return Messages.shown(e.getMessage());
    } catch (IOException e) {
      return Messages.shown(e.getMessage().replaceFirst("^" + FILE + ":\\d+:\\d+: ", ""));
    }
  }
}
