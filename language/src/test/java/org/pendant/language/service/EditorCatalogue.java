package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;

/** A few functions and methods with units and texts, enough for the examples of these tests. */
final class EditorCatalogue implements Catalogue {
  private final List<Signature> signatures = new ArrayList<>();

  EditorCatalogue() {
    add(
        "movej",
        "15.29",
        "",
        "Moves all joints to a goal. More is in the manual.",
        new Parameter("q", Type.POSE_OR_JOINTS, Unit.NONE, true, ""),
        new Parameter("a", Type.NUMBER, Unit.RADIAN_PER_SECOND_SQUARED, false, "1.4"),
        new Parameter("v", Type.NUMBER, Unit.RADIAN_PER_SECOND, false, "1.05"));
    add("movel", "15.30", "", "Moves the tool on a line.", needs("pose", Type.POSE_OR_JOINTS));
    add(
        "sleep",
        "16.54",
        "",
        "Pauses this thread.",
        new Parameter("t", Type.NUMBER, Unit.SECOND, true, ""));
    add("sync", "16.58", "", "Waits for the next frame.");
    add("textmsg", "16.60", "", "Writes to the log.", needs("s1", Type.ANY));
    add(
        "set_standard_digital_out",
        "18.50",
        "",
        "Switches an output.",
        needs("n", Type.INT),
        needs("b", Type.BOOL));
    add(
        "set_digital_out",
        "18.49",
        "set_standard_digital_out",
        "Switches an output.",
        needs("n", Type.INT),
        needs("b", Type.BOOL));
    add("set_analog_out", "18.40", "gone", "Sets an output.", needs("n", Type.INT));
    add("get_actual_tcp_pose", "16.20", "", "Where the tool is.");
    add("length", "17.10", "", "Counts elements.", needs("v", Type.ANY));
    addMethod(Type.LIST, "append", needs("element", Type.ANY));
    addMethod(Type.LIST, "length");
    addMethod(Type.MATRIX, "get_row", needs("index", Type.INT));
  }

  @Override
  public Optional<Signature> function(String name) {
    return find(Optional.empty(), name);
  }

  @Override
  public Optional<Signature> method(Type receiver, String name) {
    return find(Optional.of(receiver), name);
  }

  @Override
  public Collection<Signature> all() {
    return List.copyOf(signatures);
  }

  private Optional<Signature> find(Optional<Type> receiver, String name) {
    return signatures.stream()
        .filter(other -> other.receiver().equals(receiver) && other.name().equals(name))
        .findFirst();
  }

  private void add(
      String name, String section, String deprecated, String text, Parameter... parameters) {
    Type result = name.startsWith("get_") ? Type.POSE : Type.NONE;
    signature(Optional.empty(), name, result, section, deprecated, text, parameters);
  }

  private void addMethod(Type receiver, String name, Parameter... parameters) {
    signature(Optional.of(receiver), name, Type.ANY, "4.3", "", "A method.", parameters);
  }

  private void signature(
      Optional<Type> receiver,
      String name,
      Type result,
      String section,
      String deprecated,
      String text,
      Parameter... parameters) {
    boolean takesTime = name.startsWith("move") || (name.startsWith("s") && name.length() < 6);
    signatures.add(
        new Signature(
            "core",
            receiver,
            name,
            List.of(parameters),
            result,
            Unit.NONE,
            section,
            takesTime,
            !takesTime,
            deprecated,
            text));
  }

  private static Parameter needs(String name, Type type) {
    return new Parameter(name, type, Unit.NONE, true, "");
  }
}
