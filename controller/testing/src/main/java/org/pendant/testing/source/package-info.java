/**
 * Test files: what tests are in a text, what is marked beside them, and the one program that runs
 * each of them.
 */
package org.pendant.testing.source;
