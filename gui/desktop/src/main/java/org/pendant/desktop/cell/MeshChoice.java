package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.SceneObject;
import org.pendant.kit.text.Messages;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.mesh.MeshLook;
import org.pendant.models.mesh.MeshUnit;
import org.pendant.models.pose.Pose;
import org.pendant.text.Language;

/**
 * Mesh choice: a file of triangles that somebody is about to add to a scene, and what can be told
 * of it before.
 *
 * @param folder of the scene; empty where it was never saved
 * @param file the chosen one
 * @param unit what its numbers count; empty where nobody has said it
 */
record MeshChoice(Optional<Path> folder, Optional<Path> file, Optional<MeshUnit> unit) {
  private static final int MAX_STEM = 40;

  /** What a file is like: lines for people, and the solid if it is one. */
  record Facts(List<String> lines, String problem, Optional<MeshPart> part) {
    static final Facts NONE = new Facts(List.of(), "", Optional.empty());
  }

  /** What has to be put right before the file can be read; empty if nothing. */
  String missing() {
    if (folder.isEmpty()) {
      return text("saveTheSceneFirstMeshesAre");
    }
    if (file.isEmpty()) {
      return text("chooseAFile");
    }
    if (!file.get().startsWith(folder.get())) {
      return text("theFileMustBeInThe", folder.get());
    }
    if (!MeshFile.hasEnding(name())) {
      return text("theNameOfTheFile");
    }
    return "";
  }

  /** The unit, also where the file has one of its own. */
  Optional<MeshUnit> knownUnit() {
    return unit.or(() -> file.flatMap(each -> MeshFile.unit(each.toString())));
  }

  /** What is to be done about the unit; empty if nothing. */
  String missingUnit() {
    return knownUnit().isPresent() ? "" : text("chooseTheUnitTheFileDoes");
  }

  /** Looks at the file; not for the dispatch thread. Nothing must be missing. */
  Facts look() {
    String name = name();
    MeshUnit of = knownUnit().orElseThrow();
    try {
      MeshLook look = MeshFiles.look(folder.orElseThrow(), name, of);
      List<String> lines =
          List.of(
              text("triangles", Language.ofProcess().grouped(look.triangles())),
              rounded(look.xM())
                  + " \u00d7 "
                  + rounded(look.yM())
                  + " \u00d7 "
                  + rounded(look.zM())
                  + " m",
              look.mesh()
                  .map(mesh -> text("closedLitres", rounded(1000 * mesh.volumeM3())))
                  .orElse(text("notTheSurfaceOfASolid")));
      return new Facts(
          lines,
          look.problem().map(why -> Messages.told(name, Messages.shown(why))).orElse(""),
          look.mesh().map(mesh -> new MeshPart(name, of, mesh)));
    } catch (IOException | MeshException | IllegalArgumentException e) {
      return new Facts(
          List.of(), Messages.told(name, Messages.shown(e.getMessage())), Optional.empty());
    }
  }

  /** Four digits that tell something. */
  private static String rounded(double number) {
    return new BigDecimal(number).round(new MathContext(4)).stripTrailingZeros().toPlainString();
  }

  /** The name of the file as scenes have it. */
  private String name() {
    return folder.orElseThrow().relativize(file.orElseThrow()).toString().replace('\\', '/');
  }

  /** What an object of it is called. */
  String stem() {
    String last = String.valueOf(file.orElseThrow().getFileName());
    int dot = last.lastIndexOf('.');
    String stem = dot > 0 ? last.substring(0, dot) : last;
    return stem.length() > MAX_STEM ? stem.substring(0, MAX_STEM) : stem;
  }

  /**
   * The mass that a text says, kg; nothing is 0, which stands still.
   *
   * @throws IllegalArgumentException if it is no mass, or the solid cannot have one
   */
  static double massKg(String text, MeshPart part) {
    String bare = text.strip().replace(',', '.');
    if (bare.isEmpty()) {
      return 0;
    }
    double massKg;
    try {
      massKg = Double.parseDouble(bare);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(text("massNotNumber", text.strip()), e);
    }
    var _ = new SceneObject.Mesh("mesh", Pose.ZERO, part, Material.DEFAULT, massKg);
    return massKg;
  }
}
