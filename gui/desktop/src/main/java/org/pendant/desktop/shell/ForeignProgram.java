package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.kit.text.Messages;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.urp.ImportedProgram;
import org.pendant.project.program.urp.UrpPrograms;

/**
 * Foreign program: a program of PolyScope as a text of ours. Reading is not for the dispatch
 * thread.
 *
 * @param file where it was read
 * @param name of the program
 * @param text of a program file
 * @param remarks what was not understood
 */
record ForeignProgram(Path file, String name, String text, List<String> remarks) {
  private static final int SHOWN_REMARKS = 2;

  ForeignProgram {
    remarks = List.copyOf(remarks);
  }

  /** Whether a file is such a program. */
  static boolean is(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(UrpPrograms.ENDING);
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read or is none; its message is the file and the reason
   */
  static ForeignProgram read(Path file) throws IOException {
    String fileName = file.getFileName().toString();
    try {
      ImportedProgram read = UrpPrograms.read(fileName, Files.readAllBytes(file));
      String name = fileName.substring(0, fileName.length() - UrpPrograms.ENDING.length());
      return new ForeignProgram(
          file, name, ProgramText.write(read.tree()), few(fileName, read.remarks()));
    } catch (UnreadableFile e) {
      throw new IOException(e.told(file.toString()), e);
    } catch (IOException e) {
      throw new IOException(file + ": " + FileTrouble.reason(e), e);
    }
  }

  /** The first few remarks, and how many there are besides. */
  private static List<String> few(String fileName, List<String> remarks) {
    if (remarks.size() <= SHOWN_REMARKS) {
      return remarks.stream().map(each -> Messages.told(fileName, each)).toList();
    }
    return List.of(
        Messages.told(fileName, remarks.getFirst()),
        ShellTexts.text("moreRemarksPendantConvertListsAll", fileName, remarks.size() - 1));
  }
}
