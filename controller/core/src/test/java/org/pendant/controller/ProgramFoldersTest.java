package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;

/** Each program reads files in the folder that it was started with. */
final class ProgramFoldersTest {
  private static final String READS =
      """
      def reads():
        mc_initialize(0, p[0,0,0,0,0,0])
        sleep(0.1)
        mc_load_path("part.nc", True)
        textmsg("read")
      end
      """;

  @TempDir private Path folders;
  private RunningProgram running;
  private Optional<ProgramsFolder> own;
  private Optional<ProgramsFolder> empty;

  @BeforeEach
  void makeTheFolders() throws IOException {
    Path full = Files.createDirectory(folders.resolve("full"));
    Files.writeString(full.resolve("part.nc"), "G01 X0 Y0 Z0 F3000\nG01 X0.1 Y0 Z0 F3000\n");
    own = Optional.of(ProgramsFolder.at(full));
    empty = Optional.of(ProgramsFolder.at(Files.createDirectory(folders.resolve("empty"))));
    running = new RunningProgram();
  }

  @Test
  void aSecondaryProgramOfAnotherFolderLeavesTheRunningOneItsOwn() {
    running.done(new ProgramCommand.StartProgram(running.program(READS), own));
    running.done(
        new ProgramCommand.RunSecondary(running.program("sec s():\n  x = 1\nend\n"), empty));
    running.finish();
    assertEquals(List.of("read"), running.said());
  }

  @Test
  void aProgramThatIsRefusedLeavesTheRunningOneItsFolder() {
    running.done(new ProgramCommand.StartProgram(running.program(READS), own));
    assertInstanceOf(
        Reply.Refused.class,
        running.ask(new ProgramCommand.StartProgram(running.program("textmsg(1)\n"), empty)));
    running.finish();
    assertEquals(List.of("read"), running.said());
  }

  @Test
  void theCommonFolderIsForProgramsThatStartLater() {
    running.done(new ProgramCommand.StartProgram(running.program(READS), own));
    running.done(new ProgramCommand.SetProgramsFolder(empty.get()));
    running.finish();
    assertEquals(List.of("read"), running.said());
    running.start(READS);
    running.finish();
    assertEquals(List.of("read"), running.said());
  }
}
