package org.pendant.models.arm;

import java.io.StringWriter;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.PrettyPrinter;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.util.DefaultPrettyPrinter;

/** Arm description writer: writes one as JSON in the layout of {@link DescriptionReader}. */
final class DescriptionWriter {
  private final JsonGenerator out;

  private DescriptionWriter(JsonGenerator out) {
    this.out = out;
  }

  /** The text of a file. */
  static String text(ArmDescription arm) {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = new JsonFactory().createGenerator(new Indented(), text)) {
      new DescriptionWriter(out).write(arm);
    }
    return text.append('\n').toString();
  }

  /** Members and elements on lines of their own. */
  private static final class Indented extends ObjectWriteContext.Base {
    @Override
    public PrettyPrinter getPrettyPrinter() {
      return new DefaultPrettyPrinter();
    }

    @Override
    public boolean hasPrettyPrinter() {
      return true;
    }
  }

  private void write(ArmDescription arm) {
    out.writeStartObject();
    out.writeStringProperty("id", arm.id());
    out.writeStringProperty("displayName", arm.displayName());
    out.writeStringProperty("series", arm.series().displayName());
    out.writeObjectPropertyStart("status");
    out.writeStringProperty("kinematics", arm.status().kinematics().word());
    out.writeStringProperty("masses", arm.status().masses().word());
    out.writeStringProperty("inertias", arm.status().inertias().word());
    out.writeStringProperty("jointLimits", arm.status().jointLimits().word());
    out.writeEndObject();
    out.writeArrayPropertyStart("notes");
    arm.notes().forEach(out::writeString);
    out.writeEndArray();
    out.writeObjectPropertyStart("dh");
    number("d1", arm.dh().d1());
    number("a2", arm.dh().a2());
    number("a3", arm.dh().a3());
    number("d4", arm.dh().d4());
    number("d5", arm.dh().d5());
    number("d6", arm.dh().d6());
    out.writeEndObject();
    number("payloadKg", arm.payloadKg());
    number("reachM", arm.reachM());
    out.writeArrayPropertyStart("joints");
    for (int i = 0; i < Joints.COUNT; i++) {
      joint(arm.joints().get(i), arm.actuators().get(i));
    }
    out.writeEndArray();
    out.writeArrayPropertyStart("links");
    arm.links().forEach(this::link);
    out.writeEndArray();
    out.writeEndObject();
  }

  private void joint(JointLimits limits, Actuator drive) {
    out.writeStartObject();
    if (limits.unlimited()) {
      out.writeBooleanProperty("unlimited", true);
    } else {
      number("minRad", limits.minRad());
      number("maxRad", limits.maxRad());
    }
    number("maxSpeedRadPerS", limits.maxSpeedRadPerS());
    number("maxTorqueNm", limits.maxTorqueNm());
    number("rotorInertiaKgM2", drive.rotorInertiaKgM2());
    number("torqueConstantNmPerA", drive.torqueConstantNmPerA());
    number("lagS", drive.lagS());
    out.writeObjectPropertyStart("friction");
    number("coulombA", drive.friction().coulombA());
    number("curvedA", drive.friction().curvedA());
    number("curveSpeedRadPerS", drive.friction().curveSpeedRadPerS());
    number("viscousASPerRad", drive.friction().viscousASPerRad());
    number("loadAPerNm", drive.friction().loadAPerNm());
    out.writeEndObject();
    out.writeObjectPropertyStart("status");
    out.writeStringProperty("rotorInertia", drive.status().rotorInertia().word());
    out.writeStringProperty("torqueConstant", drive.status().torqueConstant().word());
    out.writeStringProperty("friction", drive.status().friction().word());
    out.writeEndObject();
    out.writeEndObject();
  }

  private void link(LinkMass link) {
    out.writeStartObject();
    out.writeStringProperty("name", link.name());
    number("massKg", link.massKg());
    array("comM", link.comXM(), link.comYM(), link.comZM());
    array("inertiaKgM2", link.ixx(), link.ixy(), link.ixz(), link.iyy(), link.iyz(), link.izz());
    out.writeEndObject();
  }

  private void number(String key, double value) {
    out.writeNumberProperty(key, value);
  }

  private void array(String key, double... values) {
    out.writeArrayPropertyStart(key);
    for (double each : values) {
      out.writeNumber(each);
    }
    out.writeEndArray();
  }
}
