/**
 * Tests of programs in the window: which there are beside the open program, what comes of them.
 * Open {@link org.pendant.desktop.tests.TestsView} first.
 */
package org.pendant.desktop.tests;
