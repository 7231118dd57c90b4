package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.installation.Installation;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ProgramTree;

/**
 * Program files of PolyScope 5: reads and writes {@code .urp} files. Their form is not published;
 * what is known of it is in docs/program-files.md. Whatever is not understood is kept to the
 * letter.
 */
public final class UrpPrograms {
  /** Ending of the names of such files. */
  public static final String ENDING = ".urp";

  private UrpPrograms() {}

  /**
   * Reads a program.
   *
   * @param fileName without folders; gives the program its name when the file says none
   * @param bytes of the file, compressed or plain XML
   * @throws UnreadableFile if it is no program
   */
  public static ImportedProgram read(String fileName, byte[] bytes) throws UnreadableFile {
    return read(fileName, bytes, Installation.NONE);
  }

  /**
   * Reads a program.
   *
   * @param installation tells which signals are meant by names
   * @throws UnreadableFile if it is no program
   */
  public static ImportedProgram read(String fileName, byte[] bytes, Installation installation)
      throws UnreadableFile {
    return new UrpProgramReader(PackedXml.read(bytes, UrpProgramReader.ROOT), installation)
        .read(fileName);
  }

  /** The file of a program. What is read from it again is the same tree. */
  public static byte[] write(String name, ProgramTree tree) {
    return write(name, tree, Installation.NONE);
  }

  /**
   * The file of a program.
   *
   * @param installation says which arm it is for, and where features are
   */
  public static byte[] write(String name, ProgramTree tree, Installation installation) {
    return PackedXml.packed(new UrpProgramWriter(name, tree, installation).write());
  }

  /** What people should know of the file of a program before they take it to a robot. */
  public static List<String> notes(String name, ProgramTree tree, Installation installation) {
    List<String> notes = new ArrayList<>();
    notes.add(text("experimental"));
    for (String own : ownForms(name, tree, installation)) {
      notes.add(text("ownForm", own));
    }
    return List.copyOf(notes);
  }

  /**
   * What PolyScope will not understand in the file of a program: nodes for which its form is not
   * known, and which are written in one of our own.
   */
  public static List<String> ownForms(String name, ProgramTree tree, Installation installation) {
    UrpProgramWriter writer = new UrpProgramWriter(name, tree, installation);
    var _ = writer.write();
    return writer.ownForms();
  }
}
