package org.pendant.language.check;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;

/** A catalogue just large enough to show every rule of the checker. */
final class SmallCatalogue implements Catalogue {
  private final List<Signature> signatures = new ArrayList<>();

  SmallCatalogue() {
    function("sleep", Type.NONE, true, needs("t", Type.NUMBER));
    function("sync", Type.NONE, true);
    waiting("socket_open");
    function(
        "movej",
        Type.NONE,
        true,
        needs("q", Type.POSE_OR_JOINTS),
        takes("a", Type.NUMBER),
        takes("v", Type.NUMBER),
        takes("t", Type.NUMBER),
        takes("r", Type.NUMBER));
    function("sqrt", Type.NUMBER, false, needs("f", Type.NUMBER));
    function("floor", Type.INT, false, needs("f", Type.NUMBER));
    function("textmsg", Type.NONE, false, needs("s1", Type.ANY), takes("s2", Type.ANY));
    function(
        "popup",
        Type.NONE,
        false,
        needs("s", Type.ANY),
        takes("title", Type.ANY),
        takes("warning", Type.BOOL),
        takes("error", Type.BOOL),
        takes("blocking", Type.BOOL));
    function("str_cat", Type.STRING, false, needs("op1", Type.ANY), needs("op2", Type.ANY));
    function("to_str", Type.STRING, false, needs("val", Type.ANY));
    function("time", Type.ANY, false);
    function("norm", Type.NUMBER, false, needs("a", Type.ANY));
    function("length", Type.INT, false, needs("v", Type.ANY));
    function("get_digital_in", Type.BOOL, false, needs("n", Type.INT));
    function("set_digital_out", Type.NONE, false, needs("n", Type.INT), needs("b", Type.BOOL));
    function("get_target_tcp_pose", Type.POSE, false);
    function("get_actual_joint_positions", Type.JOINTS, false);
    function("pose_trans", Type.POSE, false, needs("p_from", Type.POSE), needs("p_to", Type.POSE));
    function(
        "make_list",
        Type.LIST,
        false,
        needs("length", Type.INT),
        needs("initial_value", Type.ANY),
        takes("capacity", Type.INT));
    function("rpc_factory", Type.ANY, false, needs("type", Type.STRING), needs("url", Type.STRING));
    function(
        "interpreter_mode",
        Type.NONE,
        true,
        takes("clearQueueOnEnter", Type.BOOL),
        takes("clearOnEnd", Type.BOOL));
    add(Optional.empty(), "set_flag_old", Type.NONE, false, "set_flag", List.of());
    method(Type.LIST, "append", Type.NONE, needs("element", Type.ANY));
    method(Type.LIST, "length", Type.INT);
    method(Type.LIST, "capacity", Type.INT);
    method(Type.MATRIX, "get_row", Type.LIST, needs("index", Type.INT));
    method(Type.STRUCT, "length", Type.INT);
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
        .filter(signature -> signature.receiver().equals(receiver))
        .filter(signature -> signature.name().equals(name))
        .findFirst();
  }

  private void function(String name, Type result, boolean physicalTime, Parameter... parameters) {
    add(Optional.empty(), name, result, physicalTime, "", List.of(parameters));
  }

  /** A function that may have to wait for others, beside robot time. */
  private void waiting(String name) {
    signatures.add(
        new Signature(
            "core",
            Optional.empty(),
            name,
            List.of(),
            Type.BOOL,
            Unit.NONE,
            "",
            false,
            false,
            "",
            name));
  }

  private void method(Type receiver, String name, Type result, Parameter... parameters) {
    add(Optional.of(receiver), name, result, false, "", List.of(parameters));
  }

  private void add(
      Optional<Type> receiver,
      String name,
      Type result,
      boolean physicalTime,
      String deprecated,
      List<Parameter> parameters) {
    signatures.add(
        new Signature(
            "core",
            receiver,
            name,
            parameters,
            result,
            Unit.NONE,
            "",
            physicalTime,
            !physicalTime,
            deprecated,
            name));
  }

  private static Parameter needs(String name, Type type) {
    return new Parameter(name, type, Unit.NONE, true, "");
  }

  private static Parameter takes(String name, Type type) {
    return new Parameter(name, type, Unit.NONE, false, "0");
  }
}
