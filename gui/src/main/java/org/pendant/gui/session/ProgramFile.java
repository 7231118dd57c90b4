package org.pendant.gui.session;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;

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
  private static final int LARGEST_MIB = 32;

  private static final int MIB = 1 << 20;

  /** A file that does not exist yet: UTF-8 and line feeds. */
  public static ProgramFile create(Path path, String text) {
    return new ProgramFile(path, text, StandardCharsets.UTF_8, false);
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read, has more than 32 MiB, or is no text; its message is
   *     the file and the reason
   */
  public static ProgramFile read(Path path) throws IOException {
    try {
      return of(path, bytes(path));
    } catch (IOException e) {
      throw FileTrouble.of(path, e);
    }
  }

  private static byte[] bytes(Path path) throws IOException {
    BasicFileAttributes attributes = Files.readAttributes(path, BasicFileAttributes.class);
    if (attributes.isDirectory()) {
      throw new IOException("it is a folder");
    }
    // A pipe or a device may have no end.
    if (!attributes.isRegularFile()) {
      throw new IOException("it is no file but a device or a pipe");
    }
    long mib = Math.ceilDiv(attributes.size(), MIB);
    if (mib > LARGEST_MIB) {
      throw new IOException(
          "it has " + mib + " MiB, a program may have at most " + LARGEST_MIB + " MiB");
    }
    byte[] bytes = Files.readAllBytes(path);
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == 0) {
        throw new IOException("it is no text, byte " + (i + 1) + " is 0");
      }
    }
    return bytes;
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
   * The program in another file: written as this one is, or in UTF-8 where this charset lacks
   * characters.
   */
  public ProgramFile copyTo(Path other, String otherText) {
    Charset fitting = charset.newEncoder().canEncode(otherText) ? charset : StandardCharsets.UTF_8;
    return new ProgramFile(other, otherText, fitting, carriageReturns);
  }

  /**
   * Writes the file so that it is either the old one or the new one, whatever happens meanwhile.
   *
   * @throws IOException if it cannot be written, or has characters that its charset has not; its
   *     message is the file and the reason
   */
  public void write() throws IOException {
    AtomicFile.write(path, bytes());
  }

  byte[] bytes() throws IOException {
    String onDisk = carriageReturns ? text.replace("\n", "\r\n") : text;
    if (!charset.newEncoder().canEncode(onDisk)) {
      throw new IOException(
          path
              + ": it is written in "
              + charset
              + ", which lacks some of the characters; Save as writes UTF-8");
    }
    return onDisk.getBytes(charset);
  }
}
