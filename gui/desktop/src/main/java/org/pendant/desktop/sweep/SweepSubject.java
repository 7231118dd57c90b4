package org.pendant.desktop.sweep;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Sweep subject: what is open in the window that a plan can be about.
 *
 * @param name of the program in front
 * @param program its file; empty where it was never saved
 * @param installation the file of the installation
 * @param scene the file of the scene
 * @param robot the arm, by name
 * @param unsaved files with changes that are not on disk
 */
record SweepSubject(
    String name,
    Optional<Path> program,
    Optional<Path> installation,
    Optional<Path> scene,
    String robot,
    List<Path> unsaved) {
  SweepSubject {
    unsaved = List.copyOf(unsaved);
  }
}
