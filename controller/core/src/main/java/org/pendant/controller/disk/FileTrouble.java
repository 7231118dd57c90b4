package org.pendant.controller.disk;

import static org.pendant.controller.disk.DiskTexts.text;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;

/**
 * File error texts: why a file could not be read or written, in words instead of the name of an
 * exception.
 */
public final class FileTrouble {
  private FileTrouble() {}

  /** The reason, without the name of the file, such as {@code there is no such file}. */
  public static String reason(IOException trouble) {
    return switch (trouble) {
      case OfFile e -> reason(e.trouble);
      case NoSuchFileException e -> text("noSuchFile");
      case AccessDeniedException e -> text("accessDenied");
      case FileAlreadyExistsException e -> text("inTheWay", e.getFile());
      case NotDirectoryException e -> text("noFolder", e.getFile());
      case DirectoryNotEmptyException e -> text("folder");
      case FileSystemLoopException e -> text("linksFormLoop");
      case FileSystemException e when e.getReason() != null -> lower(e.getReason());
      default ->
          trouble.getMessage() == null
              ? trouble.getClass().getSimpleName()
              : lower(trouble.getMessage());
    };
  }

  /** An exception whose message is the file and the reason in words. */
  public static IOException of(Path file, IOException trouble) {
    return new OfFile(file, trouble);
  }

  private static final class OfFile extends IOException {
    private static final long serialVersionUID = 1L;
    private final IOException trouble;

    OfFile(Path file, IOException trouble) {
      super(file + ": " + reason(trouble), trouble);
      this.trouble = trouble;
    }
  }

  private static String lower(String sentence) {
    boolean word = sentence.length() > 1 && Character.isLowerCase(sentence.charAt(1));
    return word ? Character.toLowerCase(sentence.charAt(0)) + sentence.substring(1) : sentence;
  }
}
