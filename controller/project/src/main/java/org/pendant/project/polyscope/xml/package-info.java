/**
 * XML of PolyScope's files: mostly compressed, and an element can stand for another one by a
 * reference. Open {@link org.pendant.project.polyscope.xml.PackedXml} first.
 */
package org.pendant.project.polyscope.xml;
