package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class ProblemReportTest {
  private static final PrivateNames NAMES = new PrivateNames("/home/maria", "maria", "cell-7");
  private static final List<Finding> FINDINGS =
      List.of(PlainFindings.ok("Settings", "/home/maria/.config/pendant, 1,000 MB free"));

  @TempDir private Path folder;

  private ProblemReport report() throws IOException {
    return ProblemReport.of(FINDINGS, folder.resolve("errors.txt"), List.of(folder), NAMES);
  }

  @Test
  void withoutFaultsThereIsWhatTheDoctorFound() throws IOException {
    assertEquals("doctor.txt", report().contents());
  }

  @Test
  void notedFaultsAreInIt() throws IOException {
    Files.writeString(folder.resolve("errors.txt"), "newer\n");
    Files.writeString(folder.resolve("older-errors.txt"), "older\n");

    assertEquals("doctor.txt, older-errors.txt, errors.txt", report().contents());
    assertEquals("newer\n", report().texts().get("errors.txt"));
  }

  @Test
  void whatTheLastCrashesWereIsInIt() throws IOException {
    Files.writeString(
        folder.resolve("hs_err_pid12.log"),
        """
        #  SIGSEGV (0xb) at pc=0x00007fd34dec9f14, pid=12, tid=13
        Command Line: -XX:+UseSerialGC /home/maria/pendant.jar run /home/maria/secret.script
        C  [libGL.so.1+0x85f14]

        Registers:
        RAX=0x0
        Environment Variables:
        PASSWORD=1234
        """);

    assertEquals("doctor.txt, hs_err_pid12.log", report().contents());
    assertEquals(
        """
        #  SIGSEGV (0xb) at pc=0x00007fd34dec9f14, pid=12, tid=13
        Command Line: -XX:+UseSerialGC ~/pendant.jar run ...
        C  [libGL.so.1+0x85f14]

        """,
        report().texts().get("hs_err_pid12.log"));
  }

  @Test
  void namesOfUserFolderAndComputerAreReplaced() throws IOException {
    Files.writeString(
        folder.resolve("errors.txt"),
        "/home/maria/robots/pick.script of maria at cell-7, mariachi, cell-78\n");

    assertEquals(
        "~/robots/pick.script of USER at HOST, mariachi, cell-78\n",
        report().texts().get("errors.txt"));
    assertFalse(report().texts().get("doctor.txt").contains("maria"));
  }

  @Test
  void itIsInEnglishWhateverLanguageCommandsSpeak() throws IOException {
    Finding settings =
        Finding.ok(
            new FindingText("Settings", "\u8bbe\u7f6e"),
            new FindingText("90 MB free", "\u53ef\u7528 90 MB"));

    ProblemReport report =
        ProblemReport.of(List.of(settings), folder.resolve("errors.txt"), List.of(folder), NAMES);

    String text = report.texts().get("doctor.txt");
    assertTrue(text.contains("\nok      Settings      90 MB free\n"), text);
    assertTrue(text.endsWith("\nno problems, no notes\n"), text);
  }

  @Test
  void itIsAZipFile() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    report().write(out);

    List<String> names = new ArrayList<>();
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(out.toByteArray()))) {
      names.add(zip.getNextEntry().getName());
      String text = new String(zip.readAllBytes(), StandardCharsets.UTF_8);
      assertTrue(text.contains("Settings      ~/.config/pendant"), text);
    }
    assertEquals(List.of("doctor.txt"), names);
  }
}
