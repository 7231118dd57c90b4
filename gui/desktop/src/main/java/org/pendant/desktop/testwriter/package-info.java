/**
 * Test writer: a test of a program, written from what happened when it ran. Open {@link
 * org.pendant.desktop.testwriter.RunReader} first.
 */
package org.pendant.desktop.testwriter;
