package org.pendant.editors.dap;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.pendant.editors.lsp.text.UriPath;
import org.pendant.editors.wire.ClientLanguages;
import org.pendant.text.MessageTranslator;

/**
 * Client form: how a client counts lines and columns, names files, and what it can show.
 *
 * @param firstLine the number of the first line
 * @param firstColumn the number of the first column
 * @param uris whether files are named by URIs
 * @param progress whether it shows progress
 * @param invalidated whether it looks again when it is told that values have changed
 * @param language says what people read in their language
 */
record ClientForm(
    int firstLine,
    int firstColumn,
    boolean uris,
    boolean progress,
    boolean invalidated,
    MessageTranslator language) {
  /** What the protocol takes for granted. */
  static final ClientForm STANDARD =
      new ClientForm(1, 1, false, false, false, ClientLanguages.ENGLISH);

  /** What a client says of itself. */
  static ClientForm of(InitializeRequestArguments told) {
    return new ClientForm(
        Boolean.FALSE.equals(told.getLinesStartAt1()) ? 0 : 1,
        Boolean.FALSE.equals(told.getColumnsStartAt1()) ? 0 : 1,
        "uri".equals(told.getPathFormat()),
        Boolean.TRUE.equals(told.getSupportsProgressReporting()),
        Boolean.TRUE.equals(told.getSupportsInvalidatedEvent()),
        ClientLanguages.of(told.getLocale()));
  }

  /** A message as its people read it. */
  String shown(String message) {
    return language.shown(message);
  }

  /** The client's number of a line that is counted from 1. */
  int line(int line) {
    return line - 1 + firstLine;
  }

  /** The line, counted from 1, that the client calls {@code line}; at least 1. */
  int fromLine(int line) {
    return Math.max(1, line - firstLine + 1);
  }

  /** The client's number of a column that is counted from 1. */
  int column(int column) {
    return column - 1 + firstColumn;
  }

  /** The column, counted from 1, that the client calls {@code column}; at least 1. */
  int fromColumn(int column) {
    return Math.max(1, column - firstColumn + 1);
  }

  /** How the client names a file. */
  String name(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    return uris ? absolute.toUri().toString() : absolute.toString();
  }

  /** The file that the client names; empty for what is no name. */
  Optional<Path> file(String name) {
    if (name.startsWith("file:")) {
      return UriPath.path(name);
    }
    try {
      return Optional.of(Path.of(name));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }
}
