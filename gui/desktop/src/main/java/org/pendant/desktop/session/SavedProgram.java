package org.pendant.desktop.session;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.urp.ImportedProgram;
import org.pendant.project.program.urp.UrpxPrograms;

/**
 * Saved program: a program as it is on disk. Its methods read and write, so they are not for the
 * dispatch thread.
 *
 * @param path where it is
 * @param text what it says; lines end with a line feed. Of a program of PolyScope X, which is only
 *     read, the program tree as Pendant writes it
 * @param charset how characters are written: UTF-8, or Latin-1 for bytes that are no UTF-8
 * @param carriageReturns whether lines end with carriage return and line feed on disk
 * @param remarks what people should know about a program of PolyScope X besides
 */
public record SavedProgram(
    Path path, String text, Charset charset, boolean carriageReturns, List<String> remarks) {
  /** Far above any real program; a larger file is a mistake. */
  private static final int MAX_MIB = 32;

  private static final int MIB = 1 << 20;

  /** The remarks are copied. */
  public SavedProgram {
    remarks = List.copyOf(remarks);
  }

  /** A file that does not exist yet: UTF-8 and line feeds. */
  public static SavedProgram create(Path path, String text) {
    return new SavedProgram(path, text, StandardCharsets.UTF_8, false, List.of());
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read, has more than 32 MiB, is no text, or should be a
   *     program of PolyScope X and is none; its message is the file and the reason
   */
  public static SavedProgram read(Path path) throws IOException {
    try {
      byte[] bytes = bytes(path);
      return TreeFile.isForeign(path.toString()) ? foreign(path, bytes) : of(path, bytes);
    } catch (UnreadableFile e) {
      throw new IOException(e.told(path.toString()), e);
    } catch (IOException e) {
      throw FileTrouble.of(path, e);
    }
  }

  private static SavedProgram foreign(Path path, byte[] bytes) throws UnreadableFile {
    ImportedProgram read = UrpxPrograms.read(path.getFileName().toString(), bytes);
    List<String> remarks =
        read.remarks().stream().filter(each -> !each.equals(UrpxPrograms.ONLY_SHOWN)).toList();
    return new SavedProgram(
        path, ProgramText.write(read.tree()), StandardCharsets.UTF_8, false, remarks);
  }

  /** Whether it is a program of PolyScope X: it can be shown and run, not written. */
  public boolean readOnly() {
    return TreeFile.isForeign(path.toString());
  }

  private static byte[] bytes(Path path) throws IOException {
    BasicFileAttributes attributes = Files.readAttributes(path, BasicFileAttributes.class);
    if (attributes.isDirectory()) {
      throw new IOException(SessionTexts.text("itIsAFolder"));
    }
    // A pipe or a device may have no end.
    if (!attributes.isRegularFile()) {
      throw new IOException(SessionTexts.text("itIsNoFileButA"));
    }
    long mib = Math.ceilDiv(attributes.size(), MIB);
    if (mib > MAX_MIB) {
      throw new IOException(SessionTexts.text("itHasMibAProgramMay", mib, MAX_MIB));
    }
    byte[] bytes = Files.readAllBytes(path);
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == 0) {
        throw new IOException(SessionTexts.text("itIsNoTextByteIs", i + 1));
      }
    }
    return bytes;
  }

  static SavedProgram of(Path path, byte[] bytes) {
    Charset charset = StandardCharsets.UTF_8;
    String text;
    try {
      text = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    } catch (CharacterCodingException e) {
      charset = StandardCharsets.ISO_8859_1;
      text = new String(bytes, charset);
    }
    // Only where every line ends so: anything else would not be written as it was read.
    boolean carriageReturns = text.contains("\r\n") && !text.replace("\r\n", "").contains("\n");
    return new SavedProgram(
        path,
        carriageReturns ? text.replace("\r\n", "\n") : text,
        charset,
        carriageReturns,
        List.of());
  }

  /** The same file with another text. */
  public SavedProgram withText(String other) {
    return new SavedProgram(path, other, charset, carriageReturns, remarks);
  }

  /**
   * The program in another file: written as this one is, or in UTF-8 where this charset lacks
   * characters.
   */
  public SavedProgram copyTo(Path other, String otherText) {
    Charset fitting = charset.newEncoder().canEncode(otherText) ? charset : StandardCharsets.UTF_8;
    return new SavedProgram(other, otherText, fitting, carriageReturns, List.of());
  }

  /**
   * Writes the file so that it is either the old one or the new one, whatever happens meanwhile.
   *
   * @throws IOException if it cannot be written, has characters that its charset has not, or would
   *     be a program of PolyScope X; its message is the file and the reason
   */
  public void write() throws IOException {
    if (readOnly()) {
      throw new IOException(
          SessionTexts.text(
              "programsOfPolyscopeXAreNotWritten",
              path,
              ProgramDocument.TREE,
              ProgramDocument.SCRIPT));
    }
    AtomicFile.write(path, bytes());
  }

  byte[] bytes() throws IOException {
    String onDisk = carriageReturns ? text.replace("\n", "\r\n") : text;
    if (!charset.newEncoder().canEncode(onDisk)) {
      throw new IOException(SessionTexts.text("charsetLacksCharacters", path, charset));
    }
    return onDisk.getBytes(charset);
  }
}
