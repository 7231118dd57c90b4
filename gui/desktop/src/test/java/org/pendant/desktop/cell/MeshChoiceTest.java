package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.mesh.MeshUnit;

final class MeshChoiceTest {
  private static final String PYRAMID =
      "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 30 20 20\n"
          + "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

  @TempDir Path folder;

  private MeshChoice choice(String name, String text, MeshUnit unit) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
    return new MeshChoice(Optional.of(folder), Optional.of(file), Optional.ofNullable(unit));
  }

  @Test
  void whatASolidIsLikeIsTold() throws IOException {
    MeshChoice choice = choice("parts/pyramid.obj", PYRAMID, MeshUnit.MILLIMETRE);
    MeshChoice.Facts facts = choice.look();

    assertEquals("", choice.missing());
    assertEquals("pyramid", choice.stem());
    assertEquals(
        List.of("6 triangles", "0.06 \u00d7 0.04 \u00d7 0.02 m", "closed, 0.016 litres"),
        facts.lines());
    assertEquals("", facts.problem());
    assertEquals("parts/pyramid.obj", facts.part().orElseThrow().file());
  }

  @Test
  void whereASurfaceIsOpenIsToldWithItsSize() throws IOException {
    MeshChoice.Facts facts =
        choice("a.obj", PYRAMID.replace("f 2 3 5\n", ""), MeshUnit.MILLIMETRE).look();

    assertEquals(
        List.of("5 triangles", "0.06 \u00d7 0.04 \u00d7 0.02 m", "not the surface of a solid"),
        facts.lines());
    assertTrue(
        facts.problem().startsWith("a.obj: is not closed: 3 edges have no triangle"),
        facts.problem());
    assertTrue(facts.problem().contains("from (60, 40, 0)"), facts.problem());
    assertTrue(facts.part().isEmpty());
  }

  @Test
  void filesThatCannotBeReadAreTold() throws IOException {
    assertEquals(
        "a.obj: line 1: is \"x\", must be a number",
        choice("a.obj", "v 1 x 3\n", MeshUnit.METRE).look().problem());
    MeshChoice gone =
        new MeshChoice(
            Optional.of(folder),
            Optional.of(folder.resolve("none.stl")),
            Optional.of(MeshUnit.METRE));
    assertEquals("none.stl: is not there", gone.look().problem());
  }

  @Test
  void whatIsMissingIsToldOneAfterTheOther() throws IOException {
    assertEquals(
        "Save the scene first: meshes are files in its folder.",
        new MeshChoice(Optional.empty(), Optional.empty(), Optional.empty()).missing());
    assertEquals(
        "Choose a file.",
        new MeshChoice(Optional.of(folder), Optional.empty(), Optional.empty()).missing());
    assertEquals(
        "The file must be in the folder of the scene, " + folder + ", or below.",
        new MeshChoice(
                Optional.of(folder), Optional.of(folder.resolveSibling("a.stl")), Optional.empty())
            .missing());
    assertEquals(
        "The name of the file must end with .stl, .obj, .glb or .gltf.",
        choice("a.step", "", null).missing());
    assertEquals(
        "Choose the unit: the file does not say what its numbers count.",
        choice("a.stl", "", null).missingUnit());
    assertEquals("", choice("a.glb", "", null).missingUnit());
    assertEquals(Optional.of(MeshUnit.METRE), choice("a.glb", "", null).knownUnit());
  }

  @Test
  void aMassIsANumberThatTheSolidCanHave() throws IOException {
    var part = choice("a.obj", PYRAMID, MeshUnit.MILLIMETRE).look().part().orElseThrow();
    assertEquals(0, MeshChoice.massKg(" ", part));
    assertEquals(1.5, MeshChoice.massKg("1,5", part));
    assertEquals(
        "The mass is \"heavy\", must be a number of kg, or empty.",
        assertThrows(IllegalArgumentException.class, () -> MeshChoice.massKg("heavy", part))
            .getMessage());
    assertEquals(
        "mass is 2000 kg, must be 0.001 to 1000 kg",
        assertThrows(IllegalArgumentException.class, () -> MeshChoice.massKg("2000", part))
            .getMessage());
    var sheet =
        choice(
                "b.obj",
                PYRAMID.replace("5 20\n", "5 20\n").replace(" 20\nf", " 0.2\nf"),
                MeshUnit.MILLIMETRE)
            .look()
            .part()
            .orElseThrow();
    assertTrue(
        assertThrows(IllegalArgumentException.class, () -> MeshChoice.massKg("1", sheet))
            .getMessage()
            .startsWith("length is"));
  }
}
