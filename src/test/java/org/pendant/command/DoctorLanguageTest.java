package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/**
 * What {@code pendant doctor} says in another language, on a computer that has no display and no
 * OpenGL, and one port of which is taken; and what the report for others has of that.
 */
@Tag("slow")
final class DoctorLanguageTest {
  private static final int TAKEN = 2222;

  @TempDir private Path folder;

  @Test
  void germanIsSpokenAndTheReportIsInEnglish() throws IOException {
    assertSaid(
        "de",
        "\nok      Protokolle    ",
        " MB frei\n",
        "\nHinweis Anzeige       es gibt keine: mit dieser Sitzung ist kein Bildschirm verbunden\n",
        "\nHinweis OpenGL        EGL l\u00e4sst sich nicht laden (",
        "); die 3D-Ansicht braucht OpenGL 3.3 \u00fcber EGL: ",
        "\nProblem Port 2222     2222 (EtherNet/IP, UDP): belegt von ",
        "\n                      dieses Programm beenden oder Pendant woanders lauschen lassen: ",
        " Problem",
        " Hinweise\n");
  }

  @Test
  void chineseIsSpokenInColumnsAndTheReportIsInEnglish() throws IOException {
    assertSaid(
        "zh",
        "\n\u6b63\u5e38    Java          ",
        "\n\u6b63\u5e38    \u65e5\u5fd7          ",
        "\n\u63d0\u793a    \u663e\u793a\u5668        \u6ca1\u6709\uff1a",
        "\n\u63d0\u793a    OpenGL        \u65e0\u6cd5\u52a0\u8f7d EGL\uff08",
        "\uff09\uff1b3D \u89c6\u56fe\u9700\u8981",
        "\n\u95ee\u9898    \u7aef\u53e3 2222     2222\uff08EtherNet/IP\uff0cUDP\uff09\uff1a\u88ab",
        " \u4e2a\u95ee\u9898\uff0c");
  }

  private void assertSaid(String language, String... texts) throws IOException {
    try (DatagramSocket socket = new DatagramSocket(null)) {
      take(socket);
      Result result =
          Launcher.shell(
              folder,
              "env -u DISPLAY PENDANT_LANGUAGE="
                  + language
                  + " PENDANT_JAVA_OPTIONS=\"$PENDANT_JAVA_OPTIONS"
                  + " -Dorg.lwjgl.egl.libname=libnowhere.so\""
                  + " \"$PENDANT\" doctor --report problem.zip");
      String said =
          new String(result.output().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
      List.of(texts).forEach(each -> assertTrue(said.contains(each), each + " in " + said));
      assertEquals(69, result.exitCode());
    }
    String report = report();
    for (String each :
        List.of(
            "\nok      Logs          ",
            "\nnote    Display       there is none: no screen is connected to this session\n",
            "\nnote    OpenGL        EGL cannot be loaded (",
            "); the 3D view needs OpenGL 3.3 by EGL: ",
            "\nproblem Port 2222     2222 (EtherNet/IP, UDP): taken by ",
            "\n                      end that program, or let Pendant listen elsewhere: ")) {
      assertTrue(report.contains(each), each + " in " + report);
    }
  }

  private static void take(DatagramSocket socket) throws IOException {
    try {
      socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), TAKEN));
    } catch (BindException e) {
      // Somebody has it already, which is as good.
      assertTrue(e.getMessage().contains("in use"), e.getMessage());
    }
  }

  private String report() throws IOException {
    try (InputStream file = Files.newInputStream(folder.resolve("problem.zip"));
        ZipInputStream zip = new ZipInputStream(file)) {
      assertEquals("doctor.txt", zip.getNextEntry().getName());
      return new String(zip.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
