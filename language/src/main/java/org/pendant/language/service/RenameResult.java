package org.pendant.language.service;

import java.util.List;

/** Rename result: what a request to rename came to. */
public sealed interface RenameResult {

  /** One edit for every occurrence. */
  record Renamed(List<TextEdit> edits) implements RenameResult {
    public Renamed {
      edits = List.copyOf(edits);
    }
  }

  /** Nothing may be renamed, for a reason to show to the user. */
  record Refused(String reason) implements RenameResult {}
}
