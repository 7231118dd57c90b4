package org.pendant.protocols.panel;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.zip.GZIPInputStream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * What can be read of a program that was made on the pendant's screen: compressed XML with a tree
 * of nodes. What the nodes do stands in the script that is saved beside it.
 *
 * @param name of the program
 * @param installation that belongs to it; empty if it names none
 * @param nodes kinds of nodes in it, such as {@code Waypoint}
 */
record UrpFile(String name, String installation, Set<String> nodes) {
  /** Far above any real one; what is larger was made to fill the memory. */
  private static final int LARGEST_BYTES = 64 << 20;

  private static final String ROOT = "URProgram";
  private static final String CHILDREN = "children";
  private static final int MOST_NODES = 40;

  UrpFile {
    nodes = Set.copyOf(nodes);
  }

  /**
   * Reads one.
   *
   * @param bytes of the file
   * @throws IOException if it is not compressed, no XML, or not a program
   */
  static UrpFile read(byte[] bytes) throws IOException {
    try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
      byte[] xml = in.readNBytes(LARGEST_BYTES + 1);
      if (xml.length > LARGEST_BYTES) {
        throw new IOException("has more than " + LARGEST_BYTES + " bytes when unpacked");
      }
      return parse(new ByteArrayInputStream(xml));
    } catch (XMLStreamException e) {
      throw new IOException("is no XML: " + firstLine(String.valueOf(e.getMessage())), e);
    }
  }

  private static String firstLine(String text) {
    return text.lines().findFirst().orElse("");
  }

  private static UrpFile parse(InputStream xml) throws XMLStreamException, IOException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    XMLStreamReader reader = factory.createXMLStreamReader(xml);
    reader.nextTag();
    if (!reader.getLocalName().equals(ROOT)) {
      throw new IOException("holds a " + reader.getLocalName() + ", must hold a " + ROOT);
    }
    String name = attribute(reader, "name");
    String installation = attribute(reader, "installation");
    return new UrpFile(name, installation, nodes(reader));
  }

  private static String attribute(XMLStreamReader reader, String name) {
    String value = reader.getAttributeValue(null, name);
    return value == null ? "" : value;
  }

  /** The elements directly below a {@code children} element are the nodes of the program. */
  private static Set<String> nodes(XMLStreamReader reader) throws XMLStreamException {
    Set<String> nodes = new TreeSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(ROOT));
    while (reader.hasNext()) {
      int event = reader.next();
      if (event == XMLStreamReader.START_ELEMENT) {
        String element = reader.getLocalName();
        if (CHILDREN.equals(open.peek()) && nodes.size() < MOST_NODES) {
          nodes.add(element);
        }
        open.push(element);
      } else if (event == XMLStreamReader.END_ELEMENT) {
        open.pop();
      }
    }
    return nodes;
  }
}
