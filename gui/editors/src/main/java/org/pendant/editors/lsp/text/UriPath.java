package org.pendant.editors.lsp.text;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;

/** URI path: the files that the addresses of a client name. */
public final class UriPath {
  private UriPath() {}

  /** The file that {@code uri} names; empty for what is no file. */
  public static Optional<Path> path(String uri) {
    try {
      URI parsed = new URI(uri);
      return "file".equalsIgnoreCase(parsed.getScheme())
          ? Optional.of(Path.of(parsed))
          : Optional.empty();
    } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
      return Optional.empty();
    }
  }

  /** The file that {@code name} means in the file {@code uri}; empty for what is no file. */
  static Optional<Path> beside(String uri, String name) {
    try {
      return path(uri).map(from -> from.resolveSibling(name).normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /** The name to show for {@code uri}: its last part. */
  public static String fileName(String uri) {
    return path(uri)
        .map(Path::getFileName)
        .map(Path::toString)
        .orElseGet(() -> uri.substring(uri.lastIndexOf('/') + 1));
  }
}
