package org.pendant.editors.lsp;

import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArraySet;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.jsonrpc.CancelChecker;
import org.pendant.editors.lsp.provider.DiagnosticAnswers;
import org.pendant.editors.lsp.provider.Symbols;
import org.pendant.editors.lsp.text.Document;
import org.pendant.editors.lsp.text.UriPath;

/**
 * Workspace files: the scripts in the folders that the client has open. Of each what is asked
 * across files is kept as long as the file stays the same. For any thread.
 */
final class WorkspaceFiles {
  /** The most scripts that are looked at. */
  static final int MAX_FILES = 2000;

  /** The most bytes of a file that is looked at. */
  private static final long MAX_BYTES = 4L << 20;

  private static final int MAX_DEPTH = 16;
  private static final Set<String> ENDINGS = Set.of(".script", ".urscript");

  private final ServerSession session;
  private final Set<Path> folders = new CopyOnWriteArraySet<>();
  private final Map<Path, Facts> known = new HashMap<>();

  /**
   * What is kept of a file.
   *
   * @param stamp its size and time when it was read
   * @param id names its text
   */
  record Facts(
      String uri,
      String stamp,
      String id,
      List<Symbols.Found> symbols,
      List<Diagnostic> diagnostics) {}

  WorkspaceFiles(ServerSession session) {
    this.session = session;
  }

  void add(String folderUri) {
    UriPath.path(folderUri).ifPresent(folders::add);
  }

  void remove(String folderUri) {
    UriPath.path(folderUri).ifPresent(folders::remove);
  }

  /**
   * What is known of every script; of those that the client has open, their newest version.
   *
   * @param cancelled ends it early
   */
  synchronized List<Facts> facts(CancelChecker cancelled) {
    List<Facts> all = new ArrayList<>();
    Collection<Path> files = files();
    known.keySet().retainAll(files);
    for (Path file : files) {
      cancelled.checkCanceled();
      String uri = file.toUri().toString();
      Optional<Document> open = session.documents().find(uri);
      if (open.isPresent()) {
        all.add(facts(open.get(), ""));
      } else {
        ofDisk(file, uri).ifPresent(all::add);
      }
    }
    return all;
  }

  private Optional<Facts> ofDisk(Path file, String uri) {
    try {
      BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
      String stamp = attributes.size() + " " + attributes.lastModifiedTime();
      Facts before = known.get(file);
      if (before != null && before.stamp().equals(stamp)) {
        return Optional.of(before);
      }
      Document document = session.documents().ofDisk(uri, Files.readAllBytes(file));
      Facts found = facts(document, stamp);
      // what is wrong in one that imports others depends on these
      if (document.imported().isEmpty()) {
        known.put(file, found);
      }
      return Optional.of(found);
    } catch (IOException e) {
      // Gone or unreadable by now: nothing can be said of it.
      known.remove(file);
      return Optional.empty();
    }
  }

  private Facts facts(Document document, String stamp) {
    return new Facts(
        document.uri(),
        stamp,
        DiagnosticReports.id(document),
        Symbols.flat(document),
        DiagnosticAnswers.of(document, session.features()));
  }

  private Collection<Path> files() {
    Set<Path> found = new LinkedHashSet<>();
    for (Path folder : folders) {
      try {
        Files.walkFileTree(
            folder, EnumSet.noneOf(FileVisitOption.class), MAX_DEPTH, new Search(found));
      } catch (IOException e) {
        // A folder that cannot be read holds no script for us; the others may.
      }
    }
    return found;
  }

  /** Collects scripts, without hidden folders and those of package managers and builds. */
  private static final class Search extends SimpleFileVisitor<Path> {
    private static final Set<String> LEFT_OUT = Set.of("node_modules", "target", "build");

    private final Set<Path> found;

    Search(Set<Path> found) {
      this.found = found;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      String name = String.valueOf(folder.getFileName());
      return name.startsWith(".") || LEFT_OUT.contains(name)
          ? FileVisitResult.SKIP_SUBTREE
          : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      String name = file.getFileName().toString();
      if (attributes.isRegularFile()
          && attributes.size() <= MAX_BYTES
          && ENDINGS.stream().anyMatch(name::endsWith)) {
        found.add(file);
      }
      return found.size() < MAX_FILES ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      return FileVisitResult.CONTINUE;
    }
  }
}
