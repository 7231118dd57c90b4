package org.pendant.models.arm;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * Reads an arm description from JSON. The streaming parser alone is used: data binding would cost
 * each start of the program more than the whole file is worth. For the same reason nothing here
 * that runs on every start needs code made at run time (lambdas, text joined by plus).
 *
 * <p>The layout is the records' own: the same names with their units, links' centre of mass and
 * inertia as arrays {@code [x, y, z]} and {@code [xx, xy, xz, yy, yz, zz]}.
 */
final class DescriptionReader {
  private final String file;
  private final InputStream in;

  DescriptionReader(String file, InputStream in) {
    this.file = file;
    this.in = in;
  }

  /** Reads the whole file; an {@link IllegalStateException} says what is wrong with it. */
  ArmDescription read() {
    JsonFactory factory = new JsonFactory();
    try (JsonParser parser = factory.createParser(ObjectReadContext.empty(), in)) {
      parser.nextToken();
      return description(object(value(parser), "the file"));
    } catch (JacksonException | IllegalArgumentException e) {
      throw new IllegalStateException(file + ": " + e.getMessage(), e);
    }
  }

  private static ArmDescription description(Map<String, Object> root) {
    Map<String, Object> dh = object(root.get("dh"), "dh");
    Map<String, Object> status = object(root.get("status"), "status");
    List<JointLimits> joints = new ArrayList<>();
    List<Actuator> actuators = new ArrayList<>();
    for (Object each : array(root.get("joints"), "joints")) {
      Map<String, Object> joint = object(each, "a joint");
      joints.add(limits(joint));
      actuators.add(
          new Actuator(
              number(joint, "rotorInertiaKgM2"),
              number(joint, "coulombNm"),
              number(joint, "viscousNmSPerRad"),
              number(joint, "torqueConstantNmPerA")));
    }
    List<LinkMass> links = new ArrayList<>();
    for (Object each : array(root.get("links"), "links")) {
      links.add(link(object(each, "a link")));
    }
    return new ArmDescription(
        text(root, "id"),
        text(root, "displayName"),
        series(root),
        new DhLengths(
            number(dh, "d1"),
            number(dh, "a2"),
            number(dh, "a3"),
            number(dh, "d4"),
            number(dh, "d5"),
            number(dh, "d6")),
        joints,
        actuators,
        links,
        number(root, "payloadKg"),
        number(root, "reachM"),
        new ArmDescription.Status(
            confidence(status, "kinematics"),
            confidence(status, "masses"),
            confidence(status, "inertias"),
            confidence(status, "jointLimits"),
            confidence(status, "actuators")),
        notes(root));
  }

  private static JointLimits limits(Map<String, Object> joint) {
    boolean unlimited = Boolean.TRUE.equals(joint.get("unlimited"));
    return new JointLimits(
        unlimited ? Double.NEGATIVE_INFINITY : number(joint, "minRad"),
        unlimited ? Double.POSITIVE_INFINITY : number(joint, "maxRad"),
        number(joint, "maxSpeedRadPerS"),
        number(joint, "maxTorqueNm"));
  }

  private static Series series(Map<String, Object> root) {
    String name = text(root, "series");
    for (Series each : Series.values()) {
      if (each.displayName().equals(name)) {
        return each;
      }
    }
    throw wrong("series", name, "CB3, e-Series or UR-Series");
  }

  private static List<String> notes(Map<String, Object> root) {
    List<String> notes = new ArrayList<>();
    for (Object each : array(root.get("notes"), "notes")) {
      if (!(each instanceof String text)) {
        throw wrong("notes", each, "a text");
      }
      notes.add(text);
    }
    return notes;
  }

  private static LinkMass link(Map<String, Object> link) {
    double[] com = numbers(link, "comM", 3);
    double[] inertia = numbers(link, "inertiaKgM2", 6);
    return new LinkMass(
        text(link, "name"),
        number(link, "massKg"),
        com[0],
        com[1],
        com[2],
        inertia[0],
        inertia[1],
        inertia[2],
        inertia[3],
        inertia[4],
        inertia[5]);
  }

  private static Object value(JsonParser parser) {
    JsonToken token = parser.currentToken();
    if (token == null) {
      throw new IllegalArgumentException("is empty");
    }
    return switch (token) {
      case START_OBJECT -> {
        Map<String, Object> members = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          String name = parser.currentName();
          parser.nextToken();
          members.put(name, value(parser));
        }
        yield members;
      }
      case START_ARRAY -> {
        List<Object> elements = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          elements.add(value(parser));
        }
        yield elements;
      }
      case VALUE_STRING -> parser.getString();
      // not getDoubleValue: loading the fast number parser behind it takes longer than the file
      case VALUE_TRUE -> true;
      case VALUE_FALSE -> false;
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> Double.valueOf(parser.getString());
      default ->
          throw new IllegalArgumentException(
              token + " is not an object, array, text, number or truth value");
    };
  }

  private static Confidence confidence(Map<String, Object> object, String name) {
    return Confidence.valueOf(text(object, name).toUpperCase(Locale.ROOT));
  }

  private static String text(Map<String, Object> object, String name) {
    if (object.get(name) instanceof String text) {
      return text;
    }
    throw wrong(name, object.get(name), "a text");
  }

  private static double number(Map<String, Object> object, String name) {
    if (object.get(name) instanceof Double number) {
      return number;
    }
    throw wrong(name, object.get(name), "a number");
  }

  private static double[] numbers(Map<String, Object> object, String name, int count) {
    List<?> elements = array(object.get(name), name);
    if (elements.size() != count) {
      throw wrong(name, elements, count + " numbers");
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      if (!(elements.get(i) instanceof Double number)) {
        throw wrong(name, elements, count + " numbers");
      }
      numbers[i] = number;
    }
    return numbers;
  }

  private static List<?> array(Object value, String name) {
    if (value instanceof List<?> elements) {
      return elements;
    }
    throw wrong(name, value, "an array");
  }

  private static Map<String, Object> object(Object value, String name) {
    if (value instanceof Map<?, ?> members) {
      Map<String, Object> copy = new LinkedHashMap<>();
      for (Map.Entry<?, ?> member : members.entrySet()) {
        copy.put((String) member.getKey(), member.getValue());
      }
      return copy;
    }
    throw wrong(name, value, "an object");
  }

  private static IllegalArgumentException wrong(String name, Object value, String expected) {
    return new IllegalArgumentException(name + " is " + value + ", must be " + expected);
  }
}
