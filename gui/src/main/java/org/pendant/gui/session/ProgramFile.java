package org.pendant.gui.session;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A program as it is on disk. Its methods read and write, so they are not for the dispatch thread.
 *
 * @param path where it is
 * @param text what it says; lines end with a line feed
 * @param charset how characters are written: UTF-8, or Latin-1 for bytes that are no UTF-8
 * @param carriageReturns whether lines end with carriage return and line feed on disk
 */
public record ProgramFile(Path path, String text, Charset charset, boolean carriageReturns) {
  /** Far above any real program; a larger file is a mistake. */
  private static final int LARGEST_BYTES = 32 << 20;

  /** A file that does not exist yet: UTF-8 and line feeds. */
  public static ProgramFile create(Path path, String text) {
    return new ProgramFile(path, text, StandardCharsets.UTF_8, false);
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read, or has more than 32 MiB
   */
  public static ProgramFile read(Path path) throws IOException {
    long bytes = Files.size(path);
    if (bytes > LARGEST_BYTES) {
      throw new IOException(
          path + " has " + bytes + " bytes, a program has at most " + LARGEST_BYTES);
    }
    return of(path, Files.readAllBytes(path));
  }

  static ProgramFile of(Path path, byte[] bytes) {
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
    return new ProgramFile(
        path, carriageReturns ? text.replace("\r\n", "\n") : text, charset, carriageReturns);
  }

  /** The same file with another text. */
  public ProgramFile withText(String other) {
    return new ProgramFile(path, other, charset, carriageReturns);
  }

  /**
   * Writes the file so that it is either the old one or the new one, whatever happens meanwhile.
   *
   * @throws IOException if it cannot be written, or has characters that its charset has not
   */
  public void write() throws IOException {
    AtomicFile.write(path, bytes());
  }

  byte[] bytes() throws IOException {
    String onDisk = carriageReturns ? text.replace("\n", "\r\n") : text;
    if (!charset.newEncoder().canEncode(onDisk)) {
      throw new IOException(
          path + " is written in " + charset + ", which lacks some of the characters; use Save as");
    }
    return onDisk.getBytes(charset);
  }
}
