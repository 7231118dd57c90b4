package org.pendant.protocols.teachpendant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;

class ProgramRepositoryTest {
  private static final String URP =
      "<URProgram name=\"pick\" installation=\"cell\" installationRelativePath=\"%s\"><children>"
          + "<MainProgram><children>%s</children></MainProgram></children></URProgram>";
  private static final String CELL =
      "<Installation><TCPSettings activePose=\"Grip\"><availablePoses><tcp name=\"Grip\""
          + " offset=\"0, 0, 0.1, 0, 0, 0\"/></availablePoses></TCPSettings></Installation>";

  @TempDir private Path folder;
  private ProgramRepository programRepository;

  @BeforeEach
  void open() throws IOException {
    Files.createDirectories(folder.resolve("parts"));
    programRepository =
        new ProgramRepository(
            ProgramsFolder.at(folder), new Controller(ControllerOptions.headless()));
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private String refusal(String name) {
    return assertThrows(LoadTrouble.class, () -> programRepository.load(name)).getMessage();
  }

  @Test
  void runsTheTreeOfAUrp() throws IOException, LoadTrouble {
    write("pick.urp", URP.formatted("cell", "<Halt/>"));
    write("pick.script", "this does not compile");
    LoadedProgram loaded = programRepository.load("pick.urp");
    assertEquals("pick.urp", loaded.name());
    assertEquals("/programs/pick.urp", loaded.path());
    assertEquals("cell", loaded.installation());
    assertTrue(loaded.setup().isEmpty());
    assertTrue(
        loaded.program().orElseThrow().source().text().contains("halt"),
        loaded.program()::toString);
  }

  @Test
  void runsTheScriptBesideAUrpWithUnknownNodes() throws IOException, LoadTrouble {
    write("weld.urp", URP.formatted("cell", "<Weld/>"));
    write("weld.script", "def weld():\n  sleep(7)\nend\n");
    assertEquals(
        "def weld():\n  sleep(7)\nend\n",
        programRepository.load("weld.urp").program().orElseThrow().source().text());
  }

  @Test
  void runsAUrpWithUnknownNodesAloneIfItMust() throws IOException, LoadTrouble {
    write("weld.urp", URP.formatted("cell", "<Weld/><Halt/>"));
    assertTrue(
        programRepository
            .load("weld.urp")
            .program()
            .orElseThrow()
            .source()
            .text()
            .contains("halt"));
  }

  @Test
  void findsTheInstallationOfAProgramByItsPath() throws IOException, LoadTrouble {
    write("cell.installation", CELL);
    write("parts/pick.urp", URP.formatted("../cell", "<Halt/>"));
    LoadedProgram loaded = programRepository.load("parts/pick.urp");
    Installation setup = loaded.setup().orElseThrow();
    assertEquals("Grip", setup.activeTool());
    assertTrue(loaded.program().orElseThrow().source().text().contains("set_tcp(p[0.0, 0.0, 0.1"));
  }

  @Test
  void refusesPathsThatLeadOutOfTheFolder() throws IOException, LoadTrouble {
    Files.writeString(folder.resolveSibling("outside.installation"), CELL);
    write("pick.urp", URP.formatted("../outside", "<Halt/>"));
    assertTrue(programRepository.load("pick.urp").setup().isEmpty());
  }

  @Test
  void namesTheFirstThingThatIsMissing() throws IOException {
    write(
        "open.pendant",
        """
        pendant program 1
        main
          if
            halt
          wait what=time time-s=1
        """);
    String message = refusal("open.pendant");
    assertTrue(message.startsWith("open.pendant:3: error: condition: "), message);
    write("broken.pendant", "pendant program 1\nmain\n  jump\n");
    assertTrue(refusal("broken.pendant").startsWith("broken.pendant:3:3: error: "));
    write("other.urp", "<Installation/>");
    assertEquals(
        "other.urp:1:1: error: holds a Installation, must hold a URProgram", refusal("other.urp"));
  }
}
