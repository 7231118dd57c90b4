package org.pendant.project.polyscope.xml;

import static org.pendant.project.polyscope.xml.PolyscopeXmlTexts.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipException;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Packed XML: reads and writes such files. Nothing that a file only points to is ever loaded, and
 * what it can take up is bounded.
 */
public final class PackedXml {
  /** Far above any real one; what is larger was made to fill the memory. */
  private static final int MAX_BYTES = 64 << 20;

  /** What programs and installations were called before their form was changed altogether. */
  private static final Set<String> OLD_ROOTS =
      Set.of("gui.program.ProgramRootNode", "gui.installation.RobotInstallation");

  private static final int MAX_ELEMENTS = 1_000_000;
  private static final int DEEPEST = 1000;

  private static final String DEPTH_LIMIT = "jdk.xml.maxElementDepth";
  private static final String TEXT_LIMIT = "jdk.xml.maxGeneralEntitySizeLimit";
  private static final String WHOLE_LIMIT = "jdk.xml.totalEntitySizeLimit";
  private static final String NO_LIMIT = "0";

  private static final int GZIP_FIRST = 0x1f;
  private static final int GZIP_SECOND = 0x8b;
  private static final char BYTE_ORDER_MARK = '\ufeff';
  private static final Pattern ENCODING =
      Pattern.compile("<\\?xml[^>]*?encoding\\s*=\\s*[\"']([\\w.-]+)[\"']");

  private PackedXml() {}

  /**
   * Reads a file, compressed or plain.
   *
   * @param root name that the outermost element must have
   * @throws UnreadableFile if it is anything else
   */
  public static XmlElement read(byte[] bytes, String root) throws UnreadableFile {
    XmlElement found = parse(new XmlSource(decoded(unpacked(bytes))));
    if (OLD_ROOTS.contains(found.name())) {
      throw found.wrong(text("oldForm", found.name(), root));
    }
    if (!found.name().equals(root)) {
      throw found.wrong(text("otherRoot", found.name(), root));
    }
    return found;
  }

  /** Reads a piece of XML, one element with all that is in it. */
  public static XmlElement read(String xml) throws UnreadableFile {
    return parse(new XmlSource(xml));
  }

  /** The bytes of a compressed file. */
  public static byte[] packed(String xml) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream zip = new GZIPOutputStream(bytes)) {
      zip.write(xml.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("memory takes all bytes", e);
    }
    return bytes.toByteArray();
  }

  private static byte[] unpacked(byte[] bytes) throws UnreadableFile {
    boolean zipped =
        bytes.length > 1 && (bytes[0] & 0xff) == GZIP_FIRST && (bytes[1] & 0xff) == GZIP_SECOND;
    if (!zipped) {
      return within(bytes);
    }
    try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
      return within(in.readNBytes(MAX_BYTES + 1));
    } catch (EOFException e) {
      throw new UnreadableFile(text("cutOff"));
    } catch (ZipException e) {
      throw new UnreadableFile(text("damaged", e.getMessage()));
    } catch (IOException e) {
      throw new UncheckedIOException("memory gives all bytes", e);
    }
  }

  private static byte[] within(byte[] bytes) throws UnreadableFile {
    if (bytes.length > MAX_BYTES) {
      throw new UnreadableFile(text("tooLong", MAX_BYTES));
    }
    return bytes;
  }

  private static String decoded(byte[] bytes) throws UnreadableFile {
    Charset charset = charset(bytes);
    try {
      String text = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? text.substring(1) : text;
    } catch (CharacterCodingException e) {
      throw new UnreadableFile(text("noText", charset.name()));
    }
  }

  private static Charset charset(byte[] bytes) throws UnreadableFile {
    if (bytes.length > 1 && (bytes[0] & 0xff) + (bytes[1] & 0xff) == 0xff + 0xfe) {
      return StandardCharsets.UTF_16;
    }
    String start = new String(bytes, 0, Math.min(bytes.length, 200), StandardCharsets.ISO_8859_1);
    Matcher declared = ENCODING.matcher(start);
    String name = declared.find() ? declared.group(1).toUpperCase(Locale.ROOT) : "UTF-8";
    return switch (name) {
      case "UTF-8" -> StandardCharsets.UTF_8;
      case "US-ASCII" -> StandardCharsets.US_ASCII;
      case "ISO-8859-1", "WINDOWS-1252" -> StandardCharsets.ISO_8859_1;
      default -> throw new UnreadableFile(text("otherCharset", name));
    };
  }

  private static XmlElement parse(XmlSource source) throws UnreadableFile {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
    // its own limits are too narrow, and ours hold already; there are no entities without DOCTYPE
    factory.setProperty(DEPTH_LIMIT, String.valueOf(DEEPEST + 1));
    factory.setProperty(TEXT_LIMIT, NO_LIMIT);
    factory.setProperty(WHOLE_LIMIT, NO_LIMIT);
    try {
      XMLStreamReader reader = factory.createXMLStreamReader(new StringReader(source.text()));
      return build(reader, source);
    } catch (XMLStreamException e) {
      // Its own message says where once more, in other words and with file names that mean nothing.
      int line = e.getLocation() == null ? 0 : Math.max(0, e.getLocation().getLineNumber());
      int column = line == 0 ? 0 : Math.max(1, e.getLocation().getColumnNumber());
      throw new UnreadableFile(line, column, text("noXml", lastLine(e.getMessage())));
    }
  }

  private static String lastLine(String message) {
    String text = String.valueOf(message).strip();
    String last = text.substring(text.lastIndexOf('\n') + 1);
    return last.startsWith("Message: ") ? last.substring("Message: ".length()) : last;
  }

  private static XmlElement build(XMLStreamReader reader, XmlSource source)
      throws XMLStreamException, UnreadableFile {
    TagScanner tags = new TagScanner(source);
    Deque<XmlElement> open = new ArrayDeque<>();
    XmlElement root = null;
    boolean closed = false;
    int count = 0;
    while (reader.hasNext()) {
      switch (reader.next()) {
        case XMLStreamReader.START_ELEMENT -> {
          tags.next();
          closed = tags.closesItself();
          XmlElement element =
              new XmlElement(source, open.peek(), reader, tags.begin(), tags.comment());
          root = root == null ? element : root;
          open.push(element);
          if (++count > MAX_ELEMENTS) {
            throw element.wrong(text("tooManyElements", MAX_ELEMENTS));
          }
          if (open.size() > DEEPEST) {
            throw element.wrong(text("tooDeep", DEEPEST));
          }
        }
        case XMLStreamReader.END_ELEMENT -> {
          if (!closed) {
            tags.next();
          }
          closed = false;
          open.pop().close(tags.end());
        }
        case XMLStreamReader.CHARACTERS, XMLStreamReader.CDATA, XMLStreamReader.SPACE -> {
          if (!open.isEmpty()) {
            open.peek().append(reader.getText());
          }
        }
        case XMLStreamReader.ENTITY_REFERENCE ->
            throw open.peek().wrong(text("unknownEntity", reader.getLocalName()));
        default -> {
          // comments and the like say nothing
        }
      }
    }
    if (root == null) {
      throw new UnreadableFile(text("empty"));
    }
    return root;
  }
}
